// A tiny case in memory, whose texts a test changes before it is read.
#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/parse_case.hpp"
#include "support/replaced.hpp"

namespace darwinop::gap {

struct CsvRow {
  double t, goal, on, pos, speed, load, volt, temp;
};

inline double rounded(double value, double step) {
  return std::nearbyint(value / step) * step;
}

/// A servo that follows a sine 30 ms late: 3.2 s, a row every 16 ms, row 0 in line 2.
inline std::vector<CsvRow> sineRows(double amplitude_rad = 0.5, double hz = 0.5, int rows = 200) {
  constexpr double kTick = 2 * kPi / 4096, kLate = 0.03;
  std::vector<CsvRow> out;
  const double w = 2 * kPi * hz;
  for (int i = 0; i < rows; ++i) {
    const double t = 0.016 * i;
    const double goal = amplitude_rad * std::sin(w * t), pos = amplitude_rad * std::sin(w * (t - kLate));
    out.push_back({t, rounded(goal, kTick), 1, rounded(pos, kTick),
                   rounded(amplitude_rad * w * std::cos(w * (t - kLate)), 0.01194),
                   rounded(100 * 0.158 * 32 * (goal - pos), 0.1), 12, 30});
  }
  return out;
}

inline std::string csvOf(
    const std::vector<CsvRow>& rows,
    const std::string& head = "t_s,goal_rad,torque_on,pos_rad,speed_rad_s,load_pct,volt_V,temp_C") {
  std::string text = head + "\n";
  for (const CsvRow& r : rows) {
    char line[256];
    const int length = std::snprintf(line, sizeof line, "%.7g,%.7g,%g,%.7g,%.5g,%.4g,%.3g,%g\n", r.t, r.goal, r.on,
                                     r.pos, r.speed, r.load, r.volt, r.temp);
    text.append(line, static_cast<std::size_t>(length));
  }
  return text;
}

inline const std::string kVoltageCase = R"({
 "case": "tiny",
 "family": "pend",
 "host_dt_s": 0.016,
 "columns": "t_s,goal_rad,torque_on,pos_rad,speed_rad_s,load_pct,volt_V,temp_C",
 "baseline": {
  "model": "voltage_p",
  "params": {
   "kt_Nm_A": 1.8, "R_ohm": 8.5, "supply_V": 12.0, "duty_per_kp_per_rad": 0.158, "duty_max": 1.0,
   "armature_kgm2": 0.003, "coulomb_Nm": 0.08, "viscous_Nms_rad": 0.0, "arm_mass_kg": 0.04, "length_m": 0.17,
   "firmware_dt_s": 0.001, "ticks_per_rev": 4096
  }
 },
 "prior_rel_sigma": {"kt_Nm_A": 0.02, "R_ohm": 0.04, "payload_kg": 0.01, "coulomb_Nm": 0.1, "viscous_Nms_rad": 0.2},
 "logs": [
  {"file": "fit_1.csv", "role": "fit", "trajectory": "sine", "kp": 32, "payload_kg": 0.3, "t0_session_s": 1.5,
   "repeat_of": null},
  {"file": "score_1.csv", "role": "score", "trajectory": "sine", "kp": 32, "payload_kg": 0.3, "t0_session_s": 9,
   "repeat_of": null}
 ]
})";

/// A valid case, which a test may break.
struct CaseTexts {
  std::string json = kVoltageCase;
  std::map<std::string, std::string> logs{{"fit_1.csv", csvOf(sineRows())}, {"score_1.csv", csvOf(sineRows(0.4, 0.8))}};
  std::map<std::string, std::string> models;

  [[nodiscard]] Case read() const {
    return parseCase(json, "my/case.json",
                     {.log = [&](const std::string& name) { return logs::parseLog(at(logs, name), "my/" + name); },
                      .model = [&](const std::string& name) { return twin::parseModel(at(models, name), name); }});
  }
  /// What it is refused with; empty: it is read.
  [[nodiscard]] std::string error() const {
    try {
      (void)read();
    } catch (const BadInput& refused) {
      return refused.what();
    }
    return "";
  }

  /// With another text in the JSON.
  [[nodiscard]] CaseTexts with(const std::string& what, const std::string& by) const {
    CaseTexts changed = *this;
    changed.json = replaced(json, what, by);
    return changed;
  }
  /// With other rows in fit_1.csv.
  [[nodiscard]] CaseTexts with(const std::vector<CsvRow>& rows) const {
    CaseTexts changed = *this;
    changed.logs["fit_1.csv"] = csvOf(rows);
    return changed;
  }

 private:
  static const std::string& at(const std::map<std::string, std::string>& texts, const std::string& name) {
    const auto found = texts.find(name);
    if (found == texts.end()) throw std::runtime_error("my/" + name + ": there is no such file");
    return found->second;
  }
};

}  // namespace darwinop::gap
