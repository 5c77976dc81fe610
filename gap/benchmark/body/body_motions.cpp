#include "gap/benchmark/body/body_motions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/conversions.hpp"
#include "core/random.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRow = 0.016;            // s
constexpr double kTick = 2 * kPi / 4096;  // rad
constexpr double kPRegister = 32;
constexpr double kFree = 0.12;  // rad from an end of a joint's range

/// rad; right joints of a kind, the left ones mirrored.
struct Pose {
  double shoulder, arm_upper, arm_lower, pelvis_yaw, pelvis, leg_upper, leg_lower, ankle, foot, neck, head;
};
constexpr Pose kHanging{-0.2, 0.15, -0.2, -0.2, 0.15, -0.55, 0.8, 0.1, 0.1, 0, 0.3};
constexpr Pose kStanding{-0.84, -0.31, 0.51, 0, 0, -0.63, 0.93, 0.52, 0.01, 0, 0.2};

using Goals = std::array<double, kJoints>;

Goals goalsOf(const Pose& pose) {
  const std::array right{pose.shoulder,  pose.arm_upper, pose.arm_lower, pose.pelvis_yaw, pose.pelvis,
                         pose.leg_upper, pose.leg_lower, pose.ankle,     pose.foot};
  Goals out{};
  for (std::size_t i = 0; i < right.size(); ++i) out[2 * i] = right[i], out[2 * i + 1] = -right[i];
  out[static_cast<std::size_t>(Joint::kNeck)] = pose.neck, out[static_cast<std::size_t>(Joint::kHead)] = pose.head;
  return out;
}

double& at(Goals& goals, Joint joint) {
  return goals[static_cast<std::size_t>(joint)];
}

/// Bends a leg: the sole stays level.
void bend(Goals& goals, bool right, double by) {
  const double sign = right ? 1 : -1;
  at(goals, right ? Joint::kLegUpperR : Joint::kLegUpperL) -= sign * by;
  at(goals, right ? Joint::kLegLowerR : Joint::kLegLowerL) += sign * 2 * by;
  at(goals, right ? Joint::kAnkleR : Joint::kAnkleL) += sign * by;
}

/// Shifts the trunk to the left over level soles.
void sway(Goals& goals, double by) {
  for (const Joint joint : {Joint::kPelvR, Joint::kPelvL, Joint::kFootR, Joint::kFootL}) at(goals, joint) += by;
}

/// Swings both arms.
void swing(Goals& goals, double by) {
  at(goals, Joint::kShoulderR) += by, at(goals, Joint::kShoulderL) += by;
}

/// What one row writes: goals, P register, limp joints.
struct Commands {
  Goals goals;
  double p_register = kPRegister;
  std::array<bool, kJoints> limp{};
};
using Motion = std::function<Commands(double time_s)>;

double ramp(double time_s, double over_s) {
  const double x = std::clamp(time_s / over_s, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

Motion sines(Rng& rng) {
  struct Wave {
    double amplitude, rate, phase;
  };
  std::array<std::array<Wave, 4>, kJoints> waves{};
  for (auto& joint : waves)
    for (Wave& wave : joint) {
      const double hz = rng.between(0.35, 2.2);
      wave = {rng.between(0.05, 0.11) / std::sqrt(hz), 2 * kPi * hz, rng.between(0, 2 * kPi)};
    }
  return [waves](double t) {
    Commands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      for (const Wave& wave : waves[i])
        out.goals[i] += ramp(t, 0.3) * wave.amplitude * std::sin(wave.rate * t + wave.phase);
    return out;
  };
}

Motion triangles(double duration_s, Rng& rng) {
  Goals slope{}, phase{};
  for (std::size_t i = 0; i < kJoints; ++i) slope[i] = rng.between(0.25, 0.45), phase[i] = rng.between(0, 4);
  const double p = rng.coin() ? 16 : 8;
  return [=](double t) {
    Commands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      out.goals[i] +=
          slope[i] * (std::abs(std::remainder(t + phase[i], 4)) - std::abs(std::remainder(phase[i], 4))) / 2;
    out.p_register = 2 * t > duration_s ? p : kPRegister;
    return out;
  };
}

Motion released(Rng& rng) {
  const double lift = rng.between(0.7, 1.2), hz = rng.between(0.3, 0.5);
  return [=](double t) {
    Commands out{goalsOf(kHanging)};
    const double up = lift * ramp(t, 0.7);
    at(out.goals, Joint::kShoulderR) -= up, at(out.goals, Joint::kShoulderL) += up;
    at(out.goals, Joint::kArmLowerR) -= up / 3, at(out.goals, Joint::kArmLowerL) += up / 3;
    for (std::size_t i = 6; i < kJoints; ++i)
      out.goals[i] += 0.15 * (std::cos(2 * kPi * hz * t + static_cast<double>(i)) - std::cos(static_cast<double>(i)));
    for (std::size_t i = 0; i < 6; ++i) out.limp[i] = t > 1.0 && t < 2.3;
    return out;
  };
}

Motion squats(Rng& rng) {
  const double hz = rng.between(0.45, 0.65), depth = rng.between(0.1, 0.16), side = rng.between(0.03, 0.06),
               arms = rng.between(0.3, 0.5);
  return [=](double t) {
    Commands out{goalsOf(kStanding)};
    const double wave = 1 - std::cos(2 * kPi * hz * t);
    bend(out.goals, true, depth * wave), bend(out.goals, false, depth * wave);
    sway(out.goals, side * std::sin(3 * kPi * hz * t));
    swing(out.goals, arms * std::sin(2 * kPi * hz * t));
    at(out.goals, Joint::kNeck) += 0.5 * std::sin(kPi * hz * t);
    return out;
  };
}

Motion steps(Rng& rng) {
  Goals size{}, period{};
  for (std::size_t i = 0; i < kJoints; ++i)
    size[i] = rng.between(0.1, 0.25) * rng.sign(), period[i] = rng.between(0.4, 0.7);
  return [=](double t) {
    Commands out{goalsOf(kHanging)};
    for (std::size_t i = 0; i < kJoints; ++i)
      if (static_cast<int>(t / period[i]) % 2 == 1) out.goals[i] += size[i];
    return out;
  };
}

Motion sways(Rng& rng) {
  const double hz = rng.between(0.35, 0.6), side = rng.between(0.05, 0.075), lean = rng.between(0.02, 0.05),
               turn = rng.coin() ? rng.between(0.1, 0.25) : 0, p = rng.coin() ? 32 : 16;
  return [=](double t) {
    Commands out{goalsOf(kStanding)};
    out.p_register = p;
    sway(out.goals, side * std::sin(2 * kPi * hz * t));
    bend(out.goals, true, lean * (1 - std::cos(3 * kPi * hz * t)));
    bend(out.goals, false, lean * (1 - std::cos(3 * kPi * hz * t)));
    swing(out.goals, 0.6 * std::sin(2 * kPi * hz * t));
    at(out.goals, Joint::kPelvYR) += turn * std::sin(2 * kPi * hz * t);
    at(out.goals, Joint::kPelvYL) += turn * std::sin(2 * kPi * hz * t);
    return out;
  };
}

Motion walk(Rng& rng) {
  const double hz = rng.between(1.5, 1.75), side = rng.between(0.09, 0.11), lift = rng.between(0.2, 0.28),
               stride = rng.between(-0.02, 0.06), turn = rng.between(-0.03, 0.03);
  return [=](double t) {
    Commands out{goalsOf(kStanding)};
    const double phase = 2 * kPi * hz * t, grow = ramp(t, 0.6);
    sway(out.goals, grow * side * std::sin(phase));
    bend(out.goals, true, grow * lift * std::pow(std::max(0.0, std::sin(phase - 0.4)), 2));
    bend(out.goals, false, grow * lift * std::pow(std::max(0.0, -std::sin(phase - 0.4)), 2));
    const double forward = grow * stride * std::cos(phase);
    at(out.goals, Joint::kLegUpperR) += forward, at(out.goals, Joint::kAnkleR) += forward;
    at(out.goals, Joint::kLegUpperL) += forward, at(out.goals, Joint::kAnkleL) += forward;
    at(out.goals, Joint::kPelvYR) += grow * turn * std::cos(phase);
    at(out.goals, Joint::kPelvYL) += grow * turn * std::cos(phase);
    swing(out.goals, 4 * forward);
    return out;
  };
}

void add(BodyCase& into, BodySetup setup, int rows, bool held_out, const Motion& motion, Rng& rng) {
  BodyLog log;
  const auto of_role = std::ranges::count(into.logs, held_out, &BodyLog::held_out) + 1;
  log.file = (held_out ? "score_" : "fit_") + std::to_string(of_role) + ".csv";
  log.held_out = held_out, log.setup = setup, log.battery_v = 11.8;
  const double last = into.logs.empty() ? 0 : into.logs.back().session_start_s;
  log.session_start_s = std::round(10 * (last + rng.between(7, 10.5))) / 10;
  for (int row = 0; row < rows; ++row) log.time_s.push_back(kRow * row);
  log.from_s = 0, log.to_s = log.time_s.back();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const auto& limits = kJointTable[joint];
    Trajectory of;
    of.file = log.file, of.kind = name(setup), of.held_out = held_out, of.joint = static_cast<Joint>(joint);
    of.supply_v = log.battery_v, of.session_start_s = log.session_start_s, of.time_s = log.time_s;
    for (const double time : log.time_s) {
      const Commands now = motion(time);
      const double goal =
          std::clamp(now.goals[joint], radFromTicks(static_cast<std::uint16_t>(limits.low)).value + kFree,
                     radFromTicks(static_cast<std::uint16_t>(limits.high)).value - kFree);
      of.goal_rad.push_back(std::round(goal / kTick) * kTick);
      of.torque_on.push_back(now.limp[joint] ? 0 : 1);
      of.p_register_of_row.push_back(now.p_register);
    }
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c})
      column->assign(log.rows(), std::nan(""));
    into.joints.logs.push_back(std::move(of));
  }
  into.logs.push_back(std::move(log));
}

}  // namespace

BodyCase plannedBody(const std::string& name, std::uint64_t seed) {
  Rng rng{seed};
  BodyCase out;
  out.name = name, out.model = "darwin-op";
  out.joints.model = twin::readModel(twin::findModel(out.model));
  constexpr int kLong = 201, kHeldOut = 151, kOnFloor = 191, kShort = 41;
  const auto up = [&](const Axes& axes) { out.logs.back().up = axes; };
  const Motion first = sines(rng);
  for (int i = 0; i < 2; ++i) add(out, BodySetup::kClamped, kLong, false, first, rng), up({0, 1, 0});
  out.logs.back().repeat_of = 0;
  add(out, BodySetup::kClamped, kLong, false, triangles(kRow * kLong, rng), rng), up({rng.sign(), 0, 0});
  add(out, BodySetup::kClamped, kLong, false, released(rng), rng), up({0, 0, rng.sign()});
  add(out, BodySetup::kFloor, kLong, false, squats(rng), rng);
  add(out, BodySetup::kFloor, kLong, false, walk(rng), rng);
  add(
      out, BodySetup::kLying, kShort, false, [](double) { return Commands{goalsOf(kStanding)}; }, rng);
  out.logs.back().lies_on = rng.coin() ? "back" : "front";
  const double azimuth = rng.between(-kPi, kPi), down = rng.between(-1, 0.3), level = std::sqrt(1 - down * down);
  add(out, BodySetup::kClamped, kHeldOut, true, steps(rng), rng);
  up({level * std::cos(azimuth), down, level * std::sin(azimuth)});
  add(out, BodySetup::kFloor, kOnFloor, true, sways(rng), rng);
  add(out, BodySetup::kFloor, kOnFloor, true, walk(rng), rng);
  return out;
}

}  // namespace darwinop::gap
