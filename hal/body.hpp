// Interface of the mechanics behind a virtual board: joints driven by servos, and the trunk's IMU. Implementations:
// plain joints without physics, and the twin.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/joints.hpp"
#include "core/units.hpp"
#include "hal/byte_line.hpp"
#include "hal/frame_source.hpp"

namespace darwinop {

/// Registers of one servo that affect motion.
struct ServoDrive {
  bool torque_on = false;  // false: limp, whatever the other fields are
  bool endless = false;    // wheel or multi-turn mode: motion is not bounded by the encoder range
  double goal_rad = 0;
  double speed_limit_rad_s = 0;  // infinity: unlimited
  double accel_limit_rad_s2 = std::numeric_limits<double>::infinity();
  double torque_limit = 0;                    // 0..1 of the maximum torque
  double p_gain = 4, i_gain = 0, d_gain = 0;  // Kp, Ki, Kd of the MX-28 manual
  double supply_v = 12;
};
using Drives = std::array<ServoDrive, kJoints>;

struct JointMotion {
  double position_rad = 0, velocity_rad_s = 0;
  double load = 0;  // -1..1 as the servo reports it; positive is counter-clockwise
  // Set by the twin only. NaN: unknown, the board uses its own setting.
  double temperature_c = std::numeric_limits<double>::quiet_NaN();
  double supply_v = std::numeric_limits<double>::quiet_NaN();  // at the servo
  bool overload = false;                                       // overload protection has tripped
};

struct BodyState {
  std::array<JointMotion, kJoints> joint{};
  std::array<double, 3> gyro_rad_s{};                // x, y, z
  std::array<double, 3> accel_m_s2{0, 0, kGravity};  // x, y, z; upright and at rest
  std::uint8_t buttons = 0;                          // 1 MODE, 2 START
  double battery_drop_v = 0;                         // by what all servos draw; the board's voltage is less by it
  // World: x forward, y left, z up at the start. NaN: plain joints have no trunk.
  std::array<double, 3> trunk_m{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};
};

/// The camera of a body. The body must outlive it.
class BodyCamera : public FrameSource {
 public:
  /// Captures the present scene; the body must not step during this call. newest() then renders it, which may take
  /// milliseconds, while the body may step.
  virtual void look() noexcept = 0;
  /// Why it cannot render, known after newest(); null: it can.
  [[nodiscard]] virtual const char* renderError() const noexcept { return nullptr; }
};

class Body {
 public:
  virtual ~Body() = default;
  virtual void step(Nanos dt, const Drives& drives) noexcept = 0;
  [[nodiscard]] virtual const BodyState& state() const noexcept = 0;
  /// Why the simulation has stopped; null: no error. After an error the state is the last valid one.
  [[nodiscard]] virtual const char* error() const noexcept { return nullptr; }
  /// Clamps the trunk in the air, at rest, with this direction up (unit vector: left, up, forward of the trunk). Joints
  /// keep their angles. False: this body has no trunk to clamp.
  virtual bool clamp(const std::array<double, 3>& /*up*/) noexcept { return false; }
  /// A camera with this picture size; null: the body has none. The body may step during this call; slow initialization
  /// is deferred to the first picture. Throws std::runtime_error if the size is out of range.
  [[nodiscard]] virtual std::unique_ptr<BodyCamera> openCamera(int /*width*/, int /*height*/) { return nullptr; }
};

}  // namespace darwinop
