// Observer of a virtual servo's motor state, for tests that check registers.
#pragma once

#include <cstdint>

#include "core/joints.hpp"
#include "core/packet.hpp"

namespace darwinop::hil {

/// Registers that determine the motor's behaviour.
struct ServoState {
  bool powered = false, torque_enable = false;
  std::uint16_t torque_limit = 0;  // counts; 0 after a shutdown
  std::uint16_t goal = 0;          // ticks
  std::uint16_t speed = 0;         // counts; 0 means no limit

  /// The motor holds or moves its joint.
  [[nodiscard]] constexpr bool pulls() const { return powered && torque_enable && torque_limit > 0; }
};

enum class ServoEvent : std::uint8_t {
  kPowerOn,
  kPowerOff,
  kTripped,  // by the servo's protection
};

class ServoObserver {
 public:
  virtual ~ServoObserver() = default;
  /// An accepted write; `after` is in effect.
  virtual void written(Joint joint, std::uint8_t address, Bytes data, const ServoState& before,
                       const ServoState& after) noexcept = 0;
  /// Registers changed without a write.
  virtual void changed(Joint joint, ServoEvent event, const ServoState& before, const ServoState& after) noexcept = 0;
};

}  // namespace darwinop::hil
