// Monitors a slow move of all driven joints to one pose, with a time-out.
#pragma once

#include <array>
#include <bitset>

#include "core/joints.hpp"
#include "core/units.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

class PoseMove {
 public:
  enum class Progress : std::uint8_t { kMoving, kArrived, kTimedOut };
  using Mask = std::bitset<kJoints>;
  using Angles = std::array<Rad, kJoints>;

  explicit PoseMove(const Config& config) : config_{config} {}

  void begin() noexcept;
  /// Once a cycle. `moving`: joints that are driven; `on_the_way`: goals have not arrived yet; angles in rad.
  Progress update(const Mask& moving, bool on_the_way, const Angles& position, const Angles& target, Nanos dt) noexcept;
  /// Joints that moved and did not get within start_tolerance.
  [[nodiscard]] const Mask& missing() const noexcept { return missing_; }

 private:
  const Config& config_;
  Nanos elapsed_{0}, deadline_{0};
  Mask seen_, missing_;
};

}  // namespace darwinop::safety
