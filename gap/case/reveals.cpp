// One row a rule.
#include "gap/case/reveals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/case/plausible.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using twin::LogFeature;

// Required excitation; from the separating experiments of docs/twin/effects.md.
constexpr double kLimp = 1;        // s, some swings
constexpr double kSlow = 1;        // s
constexpr double kWarmer = 5;      // K
constexpr double kPayloads = 0.1;  // difference over the greater one
constexpr double kGains = 0.2;
constexpr double kFast = 0.3;        // of the speed without load
constexpr double kSaturated = 0.05;  // s
constexpr double kSag = 0.3;         // load at which a supply with 0.5 ohm drops by the 0.1 V that a column resolves
constexpr double kBothSides = 0.2;   // rad
constexpr double kLongSession = 30;  // s
constexpr double kHarder = 1.25;     // load over the greatest fitted one: beyond it the model extrapolates
constexpr double kSlowHost = 0.004;  // s; an MX-28's current follows its voltage within a ms

struct Seen {
  const DataCheck& check;
  const Excitation& fit;
  const Case& c;
};

/// Of values: the greatest and the smallest differ.
bool differ(const std::set<double>& values, double share) {
  return values.size() > 1 && *values.rbegin() - *values.begin() > share * std::abs(*values.rbegin());
}

struct Rule {
  std::string_view id;
  bool (*reveals)(const Seen&);
  std::string_view can, cannot, remedy;
  std::optional<LogFeature> feature;  // that effects are observable by
};

const Rule kRules[] = {
    {"load_column", [](const Seen& s) { return s.fit.load.known(); },
     "Load was measured: controller and mechanics are examined separately.",
     "No load was measured: effects of the controller and of the mechanics cannot be distinguished.",
     "read load along with position: registers 36 to 43 are one read", LogFeature::kLoadColumn},
    {"volt_column", [](const Seen& s) { return s.fit.volt_v.known() && s.fit.load.greatest() > kSag; },
     "Voltage was measured under load: a weak supply shows.",
     "No voltage under load: a weak supply cannot be distinguished from a weak motor.",
     "read the voltage along with position, in a log with strong moves", LogFeature::kVoltageColumn},
    {"torque_off", [](const Seen& s) { return s.fit.limp_s >= kLimp; },
     "The arm swings with torque off: friction shows without the motor.",
     "The arm never swings with torque off: viscous friction cannot be distinguished from the motor's back EMF.",
     "raise the arm, switch torque off, and record the swings: experiment release", LogFeature::kTorqueOff},
    {"payloads", [](const Seen& s) { return differ(s.fit.payloads_kg, kPayloads); },
     "More than one payload: friction that grows with load shows.",
     "One payload only: friction that grows with load cannot be distinguished from dry friction, nor a wrong mass from "
     "a wrong motor.",
     "repeat one log with another weight, a tenth more at least", LogFeature::kPayloads},
    {"p_gains", [](const Seen& s) { return differ(s.fit.p_registers, kGains); },
     "More than one P gain: what the controller adds changes with it, friction does not.",
     "One P gain only: position alone cannot distinguish dry friction from a dead band, nor the gain from the motor.",
     "repeat one log with half the P gain", LogFeature::kGains},
    {"slow_motion", [](const Seen& s) { return s.fit.slow_s >= kSlow; },
     "There is slow motion: friction that falls with speed shows.",
     "Hardly any slow motion: friction that falls with speed, and ripple over the angle, cannot be seen.",
     "a slow triangle, 0.05 to 0.2 rad/s: experiment slow_triangle", LogFeature::kSlowMotion},
    {"fast_motion", [](const Seen& s) { return s.fit.speed_rad_s.greatest() >= kFast * noLoadSpeed(s.c); },
     "There is fast motion: limits of speed and the motor's back EMF show.",
     "No fast motion: limits of speed and of acceleration, and the motor's back EMF, cannot be seen.",
     "large steps: experiment steps or bang", LogFeature::kFastMotion},
    {"saturation", [](const Seen& s) { return s.fit.saturated_s >= kSaturated; },
     "The load reaches its maximum at times: the limit shows.",
     "The load never reaches its maximum: a limit above the greatest load cannot be seen, a limit below it can.",
     "large steps with a heavy payload", LogFeature::kSaturation},
    {"both_sides",
     [](const Seen& s) { return s.fit.position_rad.low < -kBothSides && s.fit.position_rad.high > kBothSides; },
     "The arm goes to both sides: an offset of angle shows.",
     "The arm stays on one side: a wrong zero cannot be distinguished from a wrong mass, and backlash does not show.",
     "move to both sides of hanging", LogFeature::kBothSides},
    {"temperature", [](const Seen& s) { return s.fit.temp_c.width() >= kWarmer; },
     "The servo gets warmer by 5 K or more: effects of heat show.",
     "The temperature hardly changes, or was not measured: effects of heat cannot be seen.",
     "measure cold, and again after some minutes of strong moves", LogFeature::kTemperature},
    {"session", [](const Seen& s) { return s.fit.session_s.width() >= kLongSession; },
     "The logs span half a minute or more: changes over time are distinguished from changes with state.",
     "The logs span less than half a minute, or have no session time: changes over time cannot be distinguished from "
     "other effects.",
     "give the start of each log, t0_session_s, and measure the first one again at the end", LogFeature::kLongSession},
    {"repeats", [](const Seen& s) { return s.check.has_repeats; }, "A log is repeated: the noise floor is measured.",
     "No log is repeated: the noise floor has to be assumed.", "repeat one log without any change", std::nullopt},
    {"held_out_logs", [](const Seen& s) { return s.check.held_out.duration_s > 0; },
     "Some logs are held out to verify the result.", "No log is held out: the result cannot be verified.",
     "measure another kind of motion, \"role\": \"held_out\"", std::nullopt},
    {kHeldOutLoadFinding,
     [](const Seen& s) { return !(s.check.held_out.load.greatest() > kHarder * s.fit.load.greatest()); },
     "No held-out log loads the servo more than the fitted ones, as far as load was measured.",
     "The held-out logs load the servo more than the fitted ones: there the fitted model extrapolates.",
     "fit a log with moves as strong as those of the held-out ones", std::nullopt},
    {"host_rate",
     [](const Seen& s) {
       return std::ranges::all_of(s.check.logs, [](const LogCheck& log) { return log.period_s <= kSlowHost; });
     },
     "Rows come fast enough for delays of a few ms.",
     "Rows come slower than the servo acts: delays of less than a row cannot be seen.",
     "read a single servo, as often as the bus allows", LogFeature::kHostRate},
};

/// Ids, in the order of the catalogue.
std::vector<std::string_view> revealedBy(LogFeature feature) {
  std::vector<std::string_view> ids;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    if (std::ranges::find(effect->revealed_by, feature) != effect->revealed_by.end()) ids.push_back(effect->id);
  return ids;
}

}  // namespace

std::vector<DataFinding> reveals(const DataCheck& check, const Case& c) {
  std::vector<DataFinding> findings;
  const Seen seen{check, check.fit, c};
  for (const bool wanted : {false, true})
    for (const Rule& rule : kRules) {
      if (rule.reveals(seen) != wanted) continue;
      DataFinding finding{rule.id, wanted, std::string{wanted ? rule.can : rule.cannot}, {}, {}, rule.feature};
      if (!wanted && rule.feature) finding.effects = revealedBy(*rule.feature);
      if (!wanted) finding.remedy = rule.remedy;
      findings.push_back(std::move(finding));
    }
  return findings;
}

}  // namespace darwinop::gap
