// What happens at the motor of a virtual servo, at the moment it happens: for tests that judge registers only.
#pragma once

#include <cstdint>

#include "core/joints.hpp"
#include "core/packet.hpp"

namespace darwinop::hil {

/// The registers that decide what a motor does.
struct ServoState {
  bool powered = false, torque_enable = false;
  std::uint16_t torque_limit = 0;  // counts; 0 after the servo shut itself off
  std::uint16_t goal = 0;          // ticks
  std::uint16_t speed = 0;         // counts; 0 means no limit

  /// The motor holds or moves its joint.
  [[nodiscard]] constexpr bool pulls() const { return powered && torque_enable && torque_limit > 0; }
};

enum class ServoEvent : std::uint8_t {
  kPowerOn,
  kPowerOff,
  kTripped,  // its own protection acted
};

class ServoObserver {
 public:
  virtual ~ServoObserver() = default;
  /// A write that the servo accepted; `after` is in effect.
  virtual void written(Joint joint, std::uint8_t address, Bytes data, const ServoState& before,
                       const ServoState& after) noexcept = 0;
  /// Its registers changed without a write.
  virtual void changed(Joint joint, ServoEvent event, const ServoState& before, const ServoState& after) noexcept = 0;
};

}  // namespace darwinop::hil
