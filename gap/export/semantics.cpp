#include "gap/export/semantics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/export/joints.hpp"
#include "gap/export/replay.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct SquareSum {
  double sum = 0;
  std::size_t count = 0;
  void add(const std::vector<double>& measured, const std::vector<double>& simulated) {
    for (std::size_t i = 0; i < measured.size(); ++i)
      if (const double off = simulated[i] - measured[i]; !std::isnan(measured[i])) {
        sum += off * off;
        ++count;
      }
  }
  void add(const SquareSum& other) {
    sum += other.sum;
    count += other.count;
  }
  [[nodiscard]] double rmsMrad() const { return count == 0 ? kNan : 1e3 * std::sqrt(sum / static_cast<double>(count)); }
};

}  // namespace

ExportSettings settingsFor(const Case& given) {
  ExportSettings settings;
  settings.model = "case " + given.name;
  bool first = true;
  double sum = 0;
  std::size_t count = 0;
  for (const Trajectory& log : given.logs) {
    if (log.held_out) continue;
    if (first) {
      settings.p_register = log.p_register;
      settings.payload_kg = log.payload_kg;
      first = false;
    }
    for (const double temperature : log.temp_c)
      if (!std::isnan(temperature)) {
        sum += temperature;
        ++count;
      }
  }
  if (count > 0) settings.temperature_c = sum / static_cast<double>(count);
  return settings;
}

ReMeasured remeasure(Target target, const Case& given, const Hypothesis& hypothesis, const ExportSettings& settings) {
  const double step_s = settings.stepOf(target);
  std::vector<SquareSum> twin(given.logs.size()), there(given.logs.size());
  forEach(given.logs.size(), [&](std::size_t i) {
    const Trajectory& log = given.logs[i];
    Trace trace;
    rollOut(given, i, hypothesis, {}, trace);
    twin[i].add(log.position_rad, trace[kPositionSignal]);

    Conditions conditions = settings.conditions();
    conditions.p_register = log.p_register;
    if (log.speed_limit_rad_s > 0) conditions.speed_limit_rad_s = log.speed_limit_rad_s;
    Hypothesis here = hypothesis;
    here.pendulum = armOf(given, log, hypothesis);
    here.servo.supply_v = supplyOf(given, log, hypothesis);
    const auto joint = jointOf(target, numbersOf(here, conditions), armOf(here, log.payload_kg), step_s);
    there[i].add(log.position_rad, replay(log, given.goal_order, *joint, step_s, hypothesis));
  });

  SquareSum sums[2][2];  // fit and held out; twin and target
  ReMeasured out{.target = target,
                 .step_s = step_s,
                 .logs = {},
                 .twin_fit_mrad = kNan,
                 .target_fit_mrad = kNan,
                 .twin_held_out_mrad = kNan,
                 .target_held_out_mrad = kNan};
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    const Trajectory& log = given.logs[i];
    out.logs.push_back({log.file, log.held_out, twin[i].rmsMrad(), there[i].rmsMrad()});
    sums[log.held_out ? 1 : 0][0].add(twin[i]);
    sums[log.held_out ? 1 : 0][1].add(there[i]);
  }
  out.twin_fit_mrad = sums[0][0].rmsMrad();
  out.target_fit_mrad = sums[0][1].rmsMrad();
  out.twin_held_out_mrad = sums[1][0].rmsMrad();
  out.target_held_out_mrad = sums[1][1].rmsMrad();
  return out;
}

ReMeasured remeasure(Target target, const Case& given, const Hypothesis& hypothesis) {
  return remeasure(target, given, hypothesis, settingsFor(given));
}

std::string asText(const ReMeasured& measured) {
  const auto row = [](const std::string& what, double twin, double there) {
    char line[128];
    std::snprintf(line, sizeof line, "%-32.32s %12.2f %12.2f\n", what.c_str(), twin, there);
    return std::string{line};
  };
  char head[128];
  std::snprintf(head, sizeof head, "%-32s %12s %12s\n", "rms position error, mrad", "twin",
                std::string{infoOf(measured.target).title}.c_str());
  std::string text = head;
  for (const LogGap& log : measured.logs)
    text += row(log.file + (log.held_out ? " (held out)" : ""), log.twin_mrad, log.target_mrad);
  text += row("all logs that were fitted", measured.twin_fit_mrad, measured.target_fit_mrad);
  if (!std::isnan(measured.twin_held_out_mrad))
    text += row("all held-out logs", measured.twin_held_out_mrad, measured.target_held_out_mrad);
  return text;
}

}  // namespace darwinop::gap
