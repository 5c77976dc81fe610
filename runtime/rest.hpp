// After the end of a session: has safety done what [Safety] on_exit asks for, so that the loop may end?
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

  /// For each image after the end of session, in order; true when the loop may end.
  [[nodiscard]] bool reached(const Sensors& seen) noexcept;
  /// Longer than a kneel from anywhere can take. Nobody waits for it for ever.
  [[nodiscard]] Nanos atMost() const noexcept;

 private:
  [[nodiscard]] std::uint64_t cyclesIn(State state, const Sensors& seen, std::optional<std::uint64_t>& since) noexcept;

  safety::OnExit on_exit_;
  double gentle_speed_;  // rad/s
  std::uint64_t offline_cycles_;
  std::optional<std::uint64_t> first_, limp_since_, offline_since_;  // cycle numbers
};

}  // namespace darwinop::runtime
