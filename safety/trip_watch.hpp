// Finds out that a servo has shut itself off, by two witnesses: the error byte of every reply, and the torque
// registers that are looked at in turn. One witness once is a suspicion, twice a fact.
#pragma once

#include <cstdint>
#include <optional>

#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class TripWatch {
 public:
  enum class Verdict : std::uint8_t {
    kFine,
    kSuspect,   // leave it out until the next reading: a routine write would arm it again
    kOverload,  // shut itself off
    kOverheat,  // shut itself off
    kNotOn,     // torque is off, its torque limit is not: it has not heard "torque on"
  };

  /// `driven_for`: time since torque was switched on, nothing while the joint is not driven.
  Verdict update(const JointSensors& seen, std::optional<Nanos> driven_for) noexcept;
  /// A reset was asked: judge by readings from now on.
  void forget() noexcept { *this = TripWatch{}; }

  /// An overload bit is believed only so long after torque came on. With torque off there is no load, so a bit
  /// that is still set is a memory of the servo's; torque coming on is what clears it.
  static constexpr Nanos kGrace{std::chrono::milliseconds{300}};

 private:
  Verdict judgeLook(const JointSensors& seen) noexcept;

  Confirm bits_, off_;
  bool early_ = false;   // an overload bit in the grace: a memory, or a servo that has shut itself off already
  bool was_on_ = false;  // torque was seen on since it was switched on
  bool limit_zero_ = false;
  std::uint8_t last_bits_ = 0;
};

}  // namespace darwinop::safety
