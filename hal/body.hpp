// What a virtual board moves: joints pushed by their servos, and the inertial sensor of the trunk.
// Two bodies exist: a plain one without physics library, and the physics twin.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/joints.hpp"
#include "hal/byte_line.hpp"
#include "hal/frame_source.hpp"

namespace darwinop {

/// One servo's registers as the motion sees them.
struct ServoDrive {
  bool torque_on = false;  // false: limp, whatever else is said
  bool endless = false;    // wheel or multi-turn mode: the encoder's range is no end of travel
  double goal_rad = 0;
  double speed_limit_rad_s = 0;  // infinity: no limit
  double accel_limit_rad_s2 = std::numeric_limits<double>::infinity();
  double torque_limit = 0;                    // 0..1 of the greatest torque
  double p_gain = 4, i_gain = 0, d_gain = 0;  // Kp, Ki, Kd of the MX-28 manual
  double supply_v = 12;
};
using Drives = std::array<ServoDrive, kJoints>;

struct JointMotion {
  double position_rad = 0, velocity_rad_s = 0;
  double load = 0;  // -1..1 as the servo reports it, positive pushes counter-clockwise
  // What only a body with physics knows. NaN: it does not say, the board's own setting stands.
  double temperature_c = std::numeric_limits<double>::quiet_NaN();
  double supply_v = std::numeric_limits<double>::quiet_NaN();  // at the servo
  bool overload = false;                                       // the servo's protection has tripped
};

struct BodyState {
  std::array<JointMotion, kJoints> joint{};
  std::array<double, 3> gyro_rad_s{};               // x, y, z
  std::array<double, 3> accel_m_s2{0, 0, 9.80665};  // x, y, z; upright and at rest
  std::uint8_t buttons = 0;                         // 1 MODE, 2 START
};

/// The camera of a body that has one. The body has to outlive it.
class Eyes : public FrameSource {
 public:
  /// Remembers what there is to see; the body must not step meanwhile. newest() then draws it, which may take
  /// milliseconds, and the body may step.
  virtual void look() noexcept = 0;
  /// Why it sees nothing, in a sentence, once newest() has found out; null: it sees.
  [[nodiscard]] virtual const char* blindness() const noexcept { return nullptr; }
};

class Body {
 public:
  virtual ~Body() = default;
  virtual void step(Nanos dt, const Drives& drives) noexcept = 0;
  [[nodiscard]] virtual const BodyState& state() const noexcept = 0;
  /// Why it does not move any more, in a sentence; null: all is well. The state is the last good one then.
  [[nodiscard]] virtual const char* trouble() const noexcept { return nullptr; }
  /// Its camera, with pictures of this size; null: it has none. The body may step meanwhile; what takes long is left to
  /// the first picture. Throws std::runtime_error when the size is out of range.
  [[nodiscard]] virtual std::unique_ptr<Eyes> openEyes(int /*width*/, int /*height*/) { return nullptr; }
};

}  // namespace darwinop
