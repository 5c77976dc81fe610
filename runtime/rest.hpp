// Decides when the loop may end after the end of a session: safety has completed [Safety] on_exit.
#pragma once

#include <cstdint>
#include <optional>

#include "core/sensors.hpp"
#include "hal/byte_line.hpp"
#include "safety/config.hpp"

namespace darwinop::runtime {

class Rest {
 public:
  Rest(const safety::Config& safety, Nanos period);

  /// Call with each image after the end of session, in order. True: the loop may end.
  [[nodiscard]] bool reached(const Sensors& seen) noexcept;
  /// Time-out: longer than a kneel from any pose takes. `seen`: an image of the session, which may have a gentle_speed
  /// of its own.
  [[nodiscard]] Nanos atMost(const Sensors& seen) const noexcept;
  [[nodiscard]] static Nanos atMost(double gentle_speed) noexcept;

 private:
  [[nodiscard]] std::uint64_t cyclesIn(State state, const Sensors& seen, std::optional<std::uint64_t>& since) noexcept;

  safety::OnExit on_exit_;
  double gentle_speed_;  // rad/s
  std::uint64_t offline_cycles_;
  std::optional<std::uint64_t> first_, limp_since_, offline_since_;  // cycle numbers
};

}  // namespace darwinop::runtime
