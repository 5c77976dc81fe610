// A robot that squats and leans on the floor and lies on its back; its motion is simulated with noise and with what a
// test hides.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "gap/localize/body/floor_residuals.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {

/// Goal of a joint: knees bent, squats, and hips that pitch the trunk. `still`: only the pose.
inline double standingGoal(Joint joint, double time_s, bool still) {
  const double squat = still ? 0 : 0.1 * (1 - std::cos(4 * time_s)), lean = still ? 0 : 0.12 * std::sin(7 * time_s);
  switch (joint) {
    case Joint::kLegUpperR:
      return -0.63 - squat + lean;
    case Joint::kLegUpperL:
      return 0.63 + squat - lean;
    case Joint::kLegLowerR:
      return 0.93 + 2 * squat;
    case Joint::kLegLowerL:
      return -0.93 - 2 * squat;
    case Joint::kAnkleR:
      return 0.52 + squat;
    case Joint::kAnkleL:
      return -0.52 - squat;
    default:
      return 0;
  }
}

/// The shipped model on a level floor.
inline FloorModel shippedOnFloor() {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  return {.robot = {.robot = {bodyBaselineOf(given), {}}, .floor = {}}};
}

/// Goals of a recording; nothing is measured yet.
inline void addRecording(BodyCase& into, BodySetup setup, int rows, bool held_out) {
  BodyLog log;
  log.file = "log_" + std::to_string(into.logs.size()) + ".csv", log.held_out = held_out, log.setup = setup;
  if (setup == BodySetup::kLying) log.lies_on = "back";
  log.battery_v = 11.8;
  for (int row = 0; row < rows; ++row) log.time_s.push_back(0.016 * row);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    Trajectory of;
    of.joint = static_cast<Joint>(joint), of.time_s = log.time_s, of.supply_v = log.battery_v;
    for (const double time : log.time_s)
      of.goal_rad.push_back(standingGoal(static_cast<Joint>(joint), time, setup == BodySetup::kLying));
    of.torque_on.assign(log.rows(), 1);
    of.p_register_of_row.assign(log.rows(), 32);
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c})
      column->assign(log.rows(), std::nan(""));
    into.joints.logs.push_back(std::move(of));
  }
  into.logs.push_back(std::move(log));
}

/// A recording on the floor and a lying one for fits, and one on the floor that is held out.
inline BodyCase standingRobot(const FloorModel& hidden, std::uint64_t seed = 1) {
  BodyCase out;
  out.name = "robot";
  out.joints.model = twin::readModel(twin::findModel("darwin-op"));
  addRecording(out, BodySetup::kFloor, 90, false);
  addRecording(out, BodySetup::kLying, 20, false);
  addRecording(out, BodySetup::kFloor, 40, true);
  const MovingImu imu{out.joints.model};
  Rng rng{seed};
  for (std::size_t i = 0; i < out.logs.size(); ++i) {
    const Disturbance noise{.seed = 1000 * seed + i};
    const FloorTrace trace = rollOut(out, i, hidden.robot, &noise);
    const MovingImu::Readings sensed = imu.of(trace, hidden.imu);
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      for (std::size_t row = 0; row < out.logs[i].rows(); ++row)
        out.joints.logs[i * kJoints + joint].position_rad[row] =
            trace.position_rad(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(joint));
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t row = 0; row < out.logs[i].rows(); ++row) {
        const auto at = static_cast<Eigen::Index>(row), column = static_cast<Eigen::Index>(axis);
        out.logs[i].gyro_rad_s[axis].push_back(sensed.gyro_rad_s(at, column) + 0.03 * rng.normal());
        out.logs[i].accel_m_s2[axis].push_back(sensed.accel_m_s2(at, column) + 0.04 * rng.normal());
      }
  }
  return out;
}

}  // namespace darwinop::gap
