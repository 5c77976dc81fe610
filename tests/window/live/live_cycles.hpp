// A robot that rests upright in its start pose.
#pragma once

#include "core/conversions.hpp"
#include "gap/live/live_cycle.hpp"

namespace darwinop::window::test {

inline gap::live::LiveCycle resting(std::uint64_t cycle) {
  constexpr std::int64_t kPeriodNs = 16'000'000;
  gap::live::LiveCycle out;
  out.p_gain.fill(4);
  out.sensors.cycle = cycle;
  out.sensors.period_ns = kPeriodNs;
  out.sensors.time_ns = static_cast<std::int64_t>(cycle) * kPeriodNs;
  for (std::size_t i = 0; i < kJoints; ++i) {
    JointSensors& joint = out.sensors.joint[i];
    joint.motion.received();
    joint.position = joint.commanded = radFromTicks(kJointTable[i].start);
    joint.load = 0.1;
    joint.driven = true;
  }
  BoardSensors& board = out.sensors.board;
  board.motion.received();
  board.gyro = {RadPerSec{0}, RadPerSec{0.1}, RadPerSec{0}};
  board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{kGravity}};
  board.voltage = Volt{11.8};
  return out;
}

}  // namespace darwinop::window::test
