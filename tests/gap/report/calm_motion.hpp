// A calm motion of a robot in a stand or on the floor, simulated by gap and by the twin with a model file.
#pragma once

#include <algorithm>
#include <cmath>

#include "gap/identify/body/answer_model.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

inline constexpr double kBatteryVolt = 11.8;
inline constexpr int kRows = 32;
inline constexpr Axes kUpwards{0.48, 0.8, 0.36};     // gravity turns all joints
inline constexpr double kFinestTicks = 4096 * 1024;  // as gap/plant/body/limb_parts.cpp: an encoder without steps

inline double sideOf(Joint joint) {
  return index(joint) % 2 == 0 ? 1 : -1;
}

/// On the floor, from straight legs, whose soles are level: the trunk pitches, rolls and turns so calmly that the feet
/// stay.
inline double goalOnFloor(Joint joint, double time_s) {
  const double wave = std::sin(6 * time_s);
  switch (joint) {
    case Joint::kLegUpperR:
    case Joint::kLegUpperL:
      return sideOf(joint) * 0.15 * wave;
    case Joint::kPelvR:
    case Joint::kPelvL:
      return 0.03 * wave;
    case Joint::kFootR:
    case Joint::kFootL:
      return -0.03 * wave;
    case Joint::kPelvYR:
    case Joint::kPelvYL:
      return 0.03 * wave;
    default:
      return 0;
  }
}

/// In a stand: all joints swing.
inline double goalInStand(Joint joint, double time_s) {
  return (sideOf(joint) > 0 ? 0.4 : -0.3) * std::sin(9 * time_s);
}

inline BodyCase recordingOf(const twin::Model& model, BodySetup setup) {
  BodyCase out;
  out.name = "c";
  out.joints.model = model;
  BodyLog log;
  log.file = "log.csv", log.setup = setup, log.battery_v = kBatteryVolt;
  if (setup == BodySetup::kClamped) log.up = kUpwards;
  for (int row = 0; row < kRows; ++row) log.time_s.push_back(0.016 * row);
  for (std::size_t i = 0; i < kJoints; ++i) {
    Trajectory of;
    of.joint = static_cast<Joint>(i), of.time_s = log.time_s, of.supply_v = kBatteryVolt;
    for (const double time : log.time_s)
      of.goal_rad.push_back((setup == BodySetup::kClamped ? goalInStand : goalOnFloor)(static_cast<Joint>(i), time));
    of.torque_on.assign(kRows, 1);
    of.p_register_of_row.assign(kRows, 32);
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c})
      column->assign(kRows, std::nan(""));
    out.joints.logs.push_back(std::move(of));
  }
  out.logs.push_back(std::move(log));
  return out;
}

inline bool isClamped(const BodyCase& given) {
  return given.logs.front().setup == BodySetup::kClamped;
}

/// Signals of a recording: rows x (joints, gyroscope, accelerometer).
using Signals = Eigen::MatrixXd;

inline Signals simulatedByGap(const BodyCase& given, const FloorModel& robot) {
  if (isClamped(given)) {  // limb by limb; positions alone
    Signals out = Signals::Zero(kRows, kJoints);
    for (const Limb& limb : limbsOf(given.joints.model)) {
      const LimbTrace trace = rollOut(given, 0, limb, robot.robot.robot);
      for (std::size_t i = 0; i < limb.size(); ++i)
        out.col(static_cast<Eigen::Index>(limb[i].joint)) = trace.position_rad.col(static_cast<Eigen::Index>(i));
    }
    return out;
  }
  const FloorTrace trace = rollOut(given, 0, robot.robot);
  const MovingImu::Readings sensed = MovingImu{given.joints.model}.of(trace, robot.imu);
  Signals out(kRows, kJoints + 6);
  out << trace.position_rad, sensed.gyro_rad_s, sensed.accel_m_s2;
  return out;
}

/// The same recording of the twin with a model file: `--robot twin:FILE` without bus and registers.
inline Signals recordedFromTwin(twin::Model model, const BodyCase& given) {
  model.servo.ticks_per_rev = kFinestTicks;
  twin::RobotBodyOptions options{.ball = twin::Ball::kNone};
  if (isClamped(given)) options.clamped_up = kUpwards;
  twin::RobotBody body{model, options};
  std::array<double, kJoints> pose{};
  body.place(pose);
  Drives drives{};
  for (ServoDrive& drive : drives) drive.supply_v = kBatteryVolt;
  constexpr Nanos kCycle{1'000'000};
  constexpr int kRowCycles = 16;
  const int held_cycles = isClamped(given) ? 1000 : 1500;
  Signals out(kRows, kJoints + 6);
  for (int row = 0; row < kRows; ++row) {
    const auto write = [&](std::size_t of) {
      for (std::size_t i = 0; i < kJoints; ++i) takeRow(given.joint(0, i), of, drives[i]);
    };
    write(static_cast<std::size_t>(std::max(0, row - 1)));
    for (int cycle = 0; cycle < (row == 0 ? held_cycles : kRowCycles); ++cycle) body.step(kCycle, drives);
    const BodyState& state = body.state();
    for (std::size_t i = 0; i < kJoints; ++i) out(row, static_cast<Eigen::Index>(i)) = state.joint[i].position_rad;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      out(row, kJoints + axis) = state.gyro_rad_s[static_cast<std::size_t>(axis)];
      out(row, kJoints + 3 + axis) = state.accel_m_s2[static_cast<std::size_t>(axis)];
    }
  }
  return isClamped(given) ? Signals{out.leftCols(kJoints)} : out;
}

/// Of each signal.
inline Eigen::VectorXd rmsOf(const Signals& errors) {
  return (errors.cwiseAbs2().colwise().mean()).cwiseSqrt().transpose();
}

/// A robot without effects, and by what the twin and gap's simulation of it differ: another integrator in a stand; on
/// the floor contacts and dry friction amplify rounding errors, as six digits of a model file are.
struct Plain {
  BodyCase given;
  Signals signals, of_twin;
  Eigen::VectorXd noise;

  explicit Plain(BodySetup setup)
      : given{recordingOf(twin::readModel(twin::findModel("darwin-op")), setup)},
        signals{simulatedByGap(given, unchangedRobot(given.joints.model).model)},
        of_twin{recordedFromTwin(given.joints.model, given)},
        noise{rmsOf(of_twin - signals)} {
    for (const double drop_m : {1e-8, 2e-8, 1e-13}) {
      FloorModel dropped = unchangedRobot(given.joints.model).model;
      dropped.robot.engine.drop_m = drop_m;
      if (!isClamped(given)) noise = noise.cwiseMax(rmsOf(simulatedByGap(given, dropped) - signals));
    }
  }
};
inline const Plain& plainIn(BodySetup setup) {
  static const Plain kInStand{BodySetup::kClamped}, kOnFloor{BodySetup::kFloor};
  return setup == BodySetup::kClamped ? kInStand : kOnFloor;
}

}  // namespace darwinop::gap
