// A twin that gets the robot's commands and is read when the robot was read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "gap/live/live_cycle.hpp"
#include "gap/live/trunk_direction.hpp"
#include "hal/body.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::gap::live {

/// What holds the twin's trunk. A twin that stands free drifts away from any robot after the first slip of a sole.
enum class Support : std::uint8_t { kClamped, kFloor };

/// Nothing here reads a clock: the twin's time is that of the cycles.
class TwinReplica {
 public:
  /// Noise of the model's sensors is left out: the robot's is noise enough. Throws std::runtime_error.
  TwinReplica(twin::Model model, Support support);

  /// At rest in this pose when this cycle's goals were written. `up`: of the trunk. False: a twin on the floor cannot
  /// lie on its side.
  [[nodiscard]] bool place(const LiveCycle& cycle, const std::array<double, kJoints>& pose_rad, const Axes& up);

  /// What the twin reads in this cycle: positions, loads, gyroscope, accelerometer. `measured_rad`: where joints
  /// without torque are led to; NaN: they are limp.
  const BodyState& step(const LiveCycle& cycle, const std::array<double, kJoints>& measured_rad);

  /// Why it has stopped; null: it runs.
  [[nodiscard]] const char* error() const noexcept { return body_->error(); }

 private:
  void advanceTo(std::int64_t time_ns);
  void command(const LiveCycle& cycle, const std::array<double, kJoints>& measured_rad);

  Support support_;
  std::unique_ptr<twin::RobotBody> body_;
  Drives drives_{};
  std::int64_t now_ns_ = 0;  // on the loop's clock
  BodyState readings_;
};

}  // namespace darwinop::gap::live
