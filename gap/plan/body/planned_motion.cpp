#include "gap/plan/body/planned_motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/conversions.hpp"
#include "core/servo_limits.hpp"
#include "core/units.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/format/shape.hpp"

namespace darwinop::gap {
namespace {

using experiments::Experiment;
using experiments::Phase;
using experiments::TorqueMode;

constexpr double kRowOfPlan = 0.016;             // s
constexpr double kBattery = 11.8;                // V, where a case has none
constexpr double kTurning = 60, kLeaving = 120;  // s of a person, with the stand. Estimated
constexpr double kWayBack = 5;                   // s
constexpr double kLongest = 16;                  // s, of what is simulated: a slow bow has tipped over by then

struct Direction {
  Axes up;
  const char *where, *prepare;
};
constexpr std::array kDirections{Direction{{0, 1, 0}, "upright", "clamp the trunk upright"},
                                 Direction{{-1, 0, 0}, "on its left side", "clamp the trunk on its left side"},
                                 Direction{{1, 0, 0}, "on its right side", "clamp the trunk on its right side"},
                                 Direction{{0, 0, -1}, "face down", "clamp the trunk face down"},
                                 Direction{{0, 0, 1}, "on its back", "clamp the trunk on its back, face up"},
                                 Direction{{0, -1, 0}, "head down", "clamp the trunk upside down"}};

Experiment experimentNamed(const std::string& name) {
  return experiments::readExperiment(experiments::findExperiment(name));
}

double motionTime(const Experiment& experiment) {
  double sum = 0;
  for (const experiments::Round& round : experiment.rounds)
    for (const Phase& phase : round.phases) sum += phase.duration_s;
  return sum;
}

void addIfThere(std::vector<PlannedMotion>& all, PlannedMotion one, double person_s) try {
  const Experiment experiment = experimentNamed(one.experiment);
  one.seconds = person_s + experiment.setup.duration_s + experiment.setup.settle_s + motionTime(experiment) + kWayBack;
  all.push_back(std::move(one));
} catch (const std::runtime_error&) {  // another folder of experiments
}

/// Goals, gains and limp joints of one row after the other.
class Rows {
 public:
  Rows(BodyCase& into, const Experiment& experiment) : into_{into}, goals_{experiment.setup.pose} {
    const std::size_t first = into.joints.logs.size() - kJoints;
    for (const experiments::Round& round : experiment.rounds)
      for (const Phase& phase : round.phases) add(phase, first);
  }

 private:
  void add(const Phase& phase, std::size_t first) {
    const experiments::Pose from = goals_;
    const bool is_driven = phase.torque == TorqueMode::kLimit;
    for (double t = 0; t < phase.duration_s - kRowOfPlan / 2 && time_s_ < kLongest; t += kRowOfPlan) {
      for (const experiments::Moved& moved : phase.joints) {
        const auto j = static_cast<std::size_t>(moved.joint);
        if (is_driven) goals_[j] = experiments::goalAt(phase.goal, phase.duration_s, moved.sign, from[j], t);
      }
      for (std::size_t j = 0; j < kJoints; ++j) {
        Trajectory& of = into_.joints.logs[first + j];
        const auto moved = std::ranges::find(phase.joints, static_cast<Joint>(j), &experiments::Moved::joint);
        const bool is_limp = moved != phase.joints.end() && !is_driven;
        of.goal_rad.push_back(std::round(goals_[j] / kRadPerTick) * kRadPerTick);
        of.torque_on.push_back(is_limp ? 0 : 1);
        of.p_register_of_row.push_back((moved != phase.joints.end() ? phase.p_gain : kDefaultPGain) * kRegisterPerKp);
        of.time_s.push_back(time_s_);
      }
      into_.logs.back().time_s.push_back(time_s_);
      time_s_ += kRowOfPlan;
    }
  }

  BodyCase& into_;
  experiments::Pose goals_;
  double time_s_ = 0;
};

}  // namespace

std::vector<PlannedMotion> plannedMotions() {
  std::vector<PlannedMotion> all;
  for (const Direction& direction : kDirections)
    for (const char* const name : {"body_sines", "body_triangles", "body_release", "body_chirp"})
      addIfThere(all, {.experiment = name, .up = direction.up, .prepare = direction.prepare, .where = direction.where},
                 kTurning);
  for (const char* const side : {"back", "front"})
    addIfThere(all,
               {.experiment = "body_lie",
                .setup = BodySetup::kLying,
                .lies_on = side,
                .prepare = std::string{"lay the robot on its "} + side,
                .where = std::string{"lying on its "} + side},
               kLeaving);
  for (const char* const name : {"body_stand", "gyroscope", "bow_forward", "bow_backward"})
    addIfThere(all,
               {.experiment = name,
                .setup = BodySetup::kFloor,
                .prepare = "set the robot on a level floor",
                .where = "on the floor"},
               kLeaving);
  return all;
}

BodyCase planned(const BodyCase& given, const std::vector<PlannedMotion>& motions) {
  BodyCase out = given;
  double last_s = 0;
  for (const BodyLog& log : given.logs) last_s = std::max(last_s, log.session_start_s);
  out.logs.clear(), out.joints.logs.clear();
  for (const PlannedMotion& motion : motions) {
    BodyLog& log = out.logs.emplace_back();
    log.file = motion.name(), log.setup = motion.setup, log.up = motion.up, log.lies_on = motion.lies_on;
    log.battery_v = given.logs.empty() ? kBattery : given.logs.front().battery_v;
    log.session_start_s = last_s += motion.seconds;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      Trajectory of;
      of.file = log.file, of.kind = name(log.setup), of.joint = static_cast<Joint>(joint);
      of.supply_v = log.battery_v, of.session_start_s = log.session_start_s;
      out.joints.logs.push_back(std::move(of));
    }
    Rows{out, experimentNamed(motion.experiment)};
    log.to_s = log.time_s.empty() ? 0 : log.time_s.back();
    const std::vector<double> not_measured(log.rows(), std::nan(""));
    log.board_v.assign(log.rows(), log.battery_v);
    for (auto* sensor : {&log.gyro_rad_s, &log.accel_m_s2}) sensor->fill(not_measured);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      Trajectory& of = out.joints.logs[out.joints.logs.size() - kJoints + joint];
      for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c}) *column = not_measured;
    }
  }
  return out;
}

}  // namespace darwinop::gap
