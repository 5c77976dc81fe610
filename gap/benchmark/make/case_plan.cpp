#include "gap/benchmark/make/case_plan.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "core/servo_limits.hpp"
#include "gap/benchmark/make/motions.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kPause = 4;  // s between two logs of a session

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

// Data sheet values, rounded as the case files write them.
twin::ServoParameters sheetServo() {
  twin::ServoParameters servo;
  servo.kt_nm_a = servo.back_emf_vs_rad = rounded(kMaxTorqueNm / kStallCurrent, 1e-3);
  servo.resistance_ohm = rounded(kNominalSupply / kStallCurrent, 0.01);
  // Not kGainPerCount: Webots' default gain of 10 1/s at the factory P register, 32. The servo's own scale gives 4 1/s.
  servo.speed_gain_per_kp_1_s = 10.0 / 32;
  servo.speed_max_rad_s = rounded(kNoLoadSpeed, 0.01);
  return servo;
}

void addFriction(twin::ParameterRole friction, double value, Case& c) {
  const twin::EffectInfo* const effect = twin::effectWith(friction);
  c.model.effects.push_back({effect, {value}, {}});
  c.priors.push_back({std::string{effect->aliases[0].number}, 0.1});
}

void drawModel(Baseline baseline, Rng& rng, Case& c) {
  twin::ServoParameters& servo = c.model.servo;
  servo = sheetServo();
  c.datasheet = {sheetServo(), 0.05};
  servo.armature_kgm2 = rounded(rng.between(0.0028, 0.0036), 1e-5);
  c.pendulum.arm_mass_kg = rounded(rng.between(0.02, 0.05), 1e-3);
  c.pendulum.length_m = rounded(rng.between(0.112, 0.19), 1e-3);
  if (baseline == Baseline::kFine) {
    servo.firmware_period_s = 1e-4;
    c.quantised = false;
  }
  if (baseline == Baseline::kSpeed) {
    servo.law = twin::Law::kSpeedP;
  } else {
    servo.kt_nm_a = servo.back_emf_vs_rad = rounded(rng.between(1.74, 1.84), 1e-3);
    servo.resistance_ohm = rounded(rng.between(8.25, 8.9), 0.01);
    c.priors = {{"kt", 0.02}, {"resistance", 0.04}};
  }
  for (const Prior& prior : {Prior{"armature", 0.1}, {"payload", 0.01}, {"length", 0.01}}) c.priors.push_back(prior);
  if (baseline != Baseline::kFrictionless)
    addFriction(twin::ParameterRole::kDryFriction, rounded(rng.between(0.05, 0.1), 1e-4), c);
  addFriction(twin::ParameterRole::kViscousFriction, rounded(rng.between(0.008, 0.02), 1e-4), c);
}

struct LogPlan {
  ExcitationMotion motion;
  bool kept, low_gain, heavy, again;  // again: the log before once more
};
constexpr auto kSession = std::to_array<LogPlan>({
    {ExcitationMotion::kSlowTriangle, false, false, false, false},
    {ExcitationMotion::kSteps, false, false, false, false},
    {ExcitationMotion::kMultisine, false, false, false, false},
    {ExcitationMotion::kMultisine, false, false, false, true},
    {ExcitationMotion::kBang, false, true, false, false},
    {ExcitationMotion::kRelease, false, false, false, false},
    {ExcitationMotion::kSteps, false, true, true, false},
    {ExcitationMotion::kChirp, true, true, false, false},
    {ExcitationMotion::kMoves, true, false, true, false},
    {ExcitationMotion::kRelease, true, false, false, false},
});

/// Values that only the simulation gives.
void clearMeasured(const WarmUp& warmth, Trajectory& log) {
  const std::size_t rows = log.rows();
  log.position_rad.resize(rows, 0);  // a log that begins limp begins where it did
  for (auto* column : {&log.speed_rad_s, &log.load, &log.volt_v}) column->assign(rows, kUnknown);
  log.temp_c.resize(rows);
  for (std::size_t i = 0; i < rows; ++i)
    log.temp_c[i] = std::round(warmth.at(log.session_start_s + log.time_s[i] - log.time_s[0]));
}

void fillRows(CommandSeries commands, Trajectory& log) {
  for (std::size_t i = 0; i < commands.goal_rad.size(); ++i) {
    log.time_s.push_back(rounded(static_cast<double>(i) * kHostPeriod, 0.001));
    log.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  log.goal_rad = std::move(commands.goal_rad);
  log.torque_on = std::move(commands.torque_on);
}

void drawLogs(Baseline baseline, Rng& rng, CasePlan& plan) {
  constexpr std::array kHigh{16.0, 24.0, 32.0}, kLow{6.0, 8.0, 12.0};
  const double high = baseline == Baseline::kSpeed ? rng.pick(std::array{16.0, 24.0}) : rng.pick(kHigh);
  const double low = rng.pick(kLow);
  const double payload = rounded(rng.between(0.2, 0.42), 1e-3);
  const double heavy = payload + rounded(rng.between(0.06, 0.115), 1e-3);
  double session_s = 1;
  int fits = 0, kept = 0;
  for (const LogPlan& row : kSession) {
    Trajectory log;
    log.file = row.kept ? "score_" + std::to_string(++kept) + ".csv" : "fit_" + std::to_string(++fits) + ".csv";
    log.kind = nameOf(row.motion);
    log.held_out = row.kept;
    log.p_register = row.low_gain ? low : high;
    log.payload_kg = row.heavy ? heavy : payload;
    log.session_start_s = rounded(session_s, 0.1);
    if (row.again) {
      const Trajectory& before = plan.given.logs.back();
      log.repeat_of = plan.given.logs.size() - 1;
      fillRows({before.goal_rad, before.torque_on}, log);
    } else {
      fillRows(commandsOf(row.motion, row.kept, rng), log);
    }
    session_s = log.session_start_s + rounded(log.duration_s(), 0.1) + kPause;
    plan.given.logs.push_back(std::move(log));
  }
}

}  // namespace

std::string_view nameOf(Baseline baseline) {
  constexpr std::array<std::string_view, 4> kNames{"V0", "CV", "W", "F"};
  return kNames[static_cast<std::size_t>(baseline)];
}

double WarmUp::at(double session_s) const {
  return start_c + rise_k * (1 - std::exp(-std::max(0.0, session_s) / time_s));
}

CasePlan drawnPlan(const std::string& name, Baseline baseline, std::uint64_t seed) {
  Rng rng{seed};
  CasePlan plan;
  plan.given.name = plan.given.model.name = name;
  drawModel(baseline, rng, plan.given);
  plan.warmth.rise_k = rng.between(16, 28);
  drawLogs(baseline, rng, plan);
  for (Trajectory& log : plan.given.logs) clearMeasured(plan.warmth, log);
  return plan;
}

CasePlan planLike(const Case& other, const std::string& name) {
  CasePlan plan;
  plan.given = other;
  plan.given.name = name;
  plan.given.folder.clear();
  plan.given.warnings.clear();
  for (Trajectory& log : plan.given.logs) clearMeasured(plan.warmth, log);
  return plan;
}

}  // namespace darwinop::gap
