#include "gap/plan/commands.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/conversions.hpp"
#include "core/servo_limits.hpp"
#include "experiments/format/shape.hpp"
#include "gap/plan/messages.hpp"

namespace darwinop::gap {
namespace {

using experiments::Phase;
using experiments::TorqueMode;

constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

/// Why a phase cannot be predicted; empty: it can.
std::string_view hindrance(const Phase& phase) {
  using experiments::Until;
  const bool weak = phase.newton_meter.begin < kMaxTorqueNm || phase.newton_meter.end < kMaxTorqueNm;
  if (phase.torque == TorqueMode::kDirect) return messages::kTorqueNotLogged;
  if (phase.torque == TorqueMode::kLimit && weak) return messages::kTorqueLimitNotLogged;
  if (phase.acceleration > 0) return "it limits the acceleration, which logs do not record";
  if (phase.until == Until::kArrival || phase.until == Until::kFallen) return messages::kEndDependsOnMotion;
  return {};
}

double speedLimitOf(const Phase& phase) {
  return phase.velocity < kFullSpeed ? phase.velocity : 0;
}

class Recorder {
 public:
  Recorder(const ExperimentCandidate& candidate, const ArmSetup& stand)
      : candidate_{candidate}, stand_{stand}, goal_{candidate.experiment.setup.pose[index(stand.joint)]} {}

  void add(const Phase& phase) {
    if (const std::string_view why = hindrance(phase); !why.empty())
      throw std::runtime_error("[phase " + phase.name + "] cannot be predicted: " + std::string{why});
    const double p_register = phase.p_gain * kRegisterPerKp, speed_limit = speedLimitOf(phase);
    if (stretches_.empty() || stretches_.back().log.p_register != p_register ||
        stretches_.back().log.speed_limit_rad_s != speed_limit)
      begin(p_register, speed_limit);
    const bool driven = phase.torque == TorqueMode::kLimit;
    const double from = goal_, sign = phase.joints[0].sign;
    for (double t = 0; t < phase.duration_s - kPlannedRow / 2; t += kPlannedRow) {
      if (driven) goal_ = experiments::goalAt(phase.goal, phase.duration_s, sign, from, t);
      row(driven);
    }
    if (driven) goal_ = experiments::goalAt(phase.goal, phase.duration_s, sign, from, phase.duration_s);
    if (!driven) goal_ = stand_.hangs_at_rad;  // where a limp arm comes to rest, and the next phase begins
  }

  std::vector<Stretch> take() { return std::move(stretches_); }

 private:
  void begin(double p_register, double speed_limit) {
    Stretch& stretch = stretches_.emplace_back();
    stretch.begins_s = now_s_;
    Trajectory& log = stretch.log;
    log.file = log.kind = candidate_.experiment.name;
    log.p_register = p_register;
    log.speed_limit_rad_s = speed_limit;
    log.payload_kg = candidate_.payload_kg;
    log.session_start_s = candidate_.session_start_s + now_s_;
  }

  void row(bool driven) {
    Trajectory& log = stretches_.back().log;
    const double goal = goal_ - stand_.hangs_at_rad;
    log.time_s.push_back(static_cast<double>(log.rows()) * kPlannedRow);
    log.goal_rad.push_back(goal);
    log.torque_on.push_back(driven ? 1 : 0);
    log.position_rad.push_back(log.rows() == 1 && driven ? goal : log.rows() == 1 ? 0 : kUnmeasured);
    for (auto* column : {&log.speed_rad_s, &log.load, &log.volt_v}) column->push_back(kUnmeasured);
    log.temp_c.push_back(candidate_.temp_c);
    log.lines.push_back(static_cast<std::uint32_t>(log.rows() + 1));
    now_s_ += kPlannedRow;
  }

  const ExperimentCandidate& candidate_;
  const ArmSetup& stand_;
  double goal_, now_s_ = 0;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::vector<Stretch> commandsOf(const ExperimentCandidate& candidate, const experiments::Round& round,
                                const ArmSetup& stand) {
  Recorder recorder{candidate, stand};
  for (const Phase& phase : round.phases) recorder.add(phase);
  return recorder.take();
}

Case planned(const Case& given, const std::vector<Stretch>& stretches) {
  Case made = given;
  made.goal_order = GoalOrder::kAfterRead;
  made.logs.clear();
  for (const Stretch& stretch : stretches) made.logs.push_back(stretch.log);
  return made;
}

}  // namespace darwinop::gap
