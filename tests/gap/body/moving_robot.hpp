// A robot with a clamped trunk whose joints follow sines and, in a second recording, slow triangles; its motion is
// simulated with noise and with what a test hides.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/conversions.hpp"
#include "core/units.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

inline Trajectory commandsOf(std::size_t joint, bool is_slow, const BodyLog& log) {
  Trajectory out;
  out.file = log.file, out.kind = name(log.setup), out.held_out = log.held_out, out.joint = static_cast<Joint>(joint);
  out.supply_v = log.battery_v, out.time_s = log.time_s;
  const auto& limits = kJointTable[joint];
  const double middle = radFromTicks(static_cast<std::uint16_t>((limits.low + limits.high) / 2)).value;
  const auto phase = static_cast<double>(joint);
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double t = log.time_s[row];
    const double triangle = std::abs(std::remainder(0.45 * t + 0.05 * phase, 2)) - 0.5;
    const double goal = is_slow ? 0.6 * triangle : 0.2 * std::sin(4 * t + phase) + 0.08 * std::sin(11 * t + 2 * phase);
    out.goal_rad.push_back(std::round((middle + goal) * 4096 / (2 * kPi)) * 2 * kPi / 4096);
    out.torque_on.push_back(1);
    out.p_register_of_row.push_back(is_slow && 2 * row > log.rows() ? 16 : 32);
    for (auto* column : {&out.position_rad, &out.load, &out.speed_rad_s, &out.volt_v, &out.temp_c})
      column->push_back(std::nan(""));
  }
  return out;
}

/// Two recordings for fits, upright and on a side, and one that is held out.
inline BodyCase movingRobot(const BodyHypothesis& hidden, std::uint64_t seed = 1) {
  BodyCase out;
  out.name = "robot";
  out.joints.model = twin::readModel(twin::findModel("darwin-op"));
  const std::vector<Limb> limbs = limbsOf(out.joints.model);
  const std::vector<Axes> ups{{0, 1, 0}, {1, 0, 0}, {0.48, 0.6, 0.64}};
  for (std::size_t i = 0; i < ups.size(); ++i) {
    BodyLog log;
    log.file = "log_" + std::to_string(i) + ".csv", log.held_out = i == 2, log.setup = BodySetup::kClamped;
    log.up = ups[i], log.battery_v = 11.8;
    for (int row = 0; row < 160; ++row) log.time_s.push_back(0.016 * row);
    log.board_v.assign(log.rows(), 11.8);
    for (auto* sensor : {&log.gyro_rad_s, &log.accel_m_s2}) sensor->fill(std::vector<double>(log.rows(), std::nan("")));
    for (std::size_t joint = 0; joint < kJoints; ++joint) out.joints.logs.push_back(commandsOf(joint, i == 1, log));
    out.logs.push_back(std::move(log));
    const Disturbance noise{.seed = 1000 * seed + i};
    for (const Limb& limb : limbs) {
      const LimbTrace trace = rollOut(out, i, limb, hidden, &noise);
      for (std::size_t k = 0; k < limb.size(); ++k) {
        Trajectory& of = out.joints.logs[i * kJoints + static_cast<std::size_t>(limb[k].joint)];
        for (std::size_t row = 0; row < of.rows(); ++row) {
          const auto at = static_cast<Eigen::Index>(row), column = static_cast<Eigen::Index>(k);
          of.position_rad[row] = trace.position_rad(at, column);
          of.load[row] = std::round(trace.duty(at, column) * 1023) / 1023;
        }
      }
    }
  }
  return out;
}

/// The shipped model as it is.
inline BodyHypothesis shippedRobot() {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  return {bodyBaselineOf(given), {}};
}

}  // namespace darwinop::gap
