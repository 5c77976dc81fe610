// What a run did not do as asked: joints that gave no readings, goals that the robot's limits changed.
#pragma once

#include <array>
#include <bitset>
#include <limits>
#include <string>
#include <vector>

#include "core/sensors.hpp"
#include "experiments/format/plan.hpp"

namespace darwinop::experiments {

// After the joint's name.
inline constexpr const char* kNotMeasured =
    ": no readings in half of the steps or more; examine it with darwinop doctor";
inline constexpr const char* kGoalsClamped = ": goals were clamped to its limits, which darwinop doctor prints; asked ";

class Shortfalls {
 public:
  /// Watches the joints that `plan` moves and those that are recorded, without the absent ones.
  Shortfalls(const Plan& plan, const std::vector<Joint>& recorded, const std::bitset<kJoints>& absent);

  /// Once per step of the experiment's phases. `asked`: goals of the step, rad.
  void update(const Pose& asked, const Sensors& sensors);

  /// One line per joint without readings in half of the steps or more; empty: none.
  [[nodiscard]] std::string unmeasuredText() const;
  /// One line per measured joint whose goals were clamped; empty: none.
  [[nodiscard]] std::string clampedText() const;

 private:
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void include(double value);
  };
  struct Seen {
    std::uint32_t measured = 0;  // steps with a reading
    Range asked, commanded;      // rad; commanded: by the safety layer
  };
  [[nodiscard]] bool isUnmeasured(std::size_t joint) const;
  [[nodiscard]] bool isClamped(std::size_t joint) const;

  std::bitset<kJoints> moved_, measured_;
  std::array<Seen, kJoints> seen_{};
  std::uint32_t steps_ = 0, first_hits_ = 0, hits_ = 0;  // of position limits, all joints
};

}  // namespace darwinop::experiments
