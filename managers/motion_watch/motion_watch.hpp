// Statistics of a motion: peak tracking errors and loads, faults, safety limits, bus errors.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <string>

#include "core/sensors.hpp"

namespace darwinop::motion {

class MotionWatch {
 public:
  /// faultsText() without any.
  static constexpr const char* kNoFaults = "no faults, no goal cut, nothing lost on the bus\n";

  /// Call once per cycle; `seconds` since the start of the motion. Counters are relative to the first call.
  void update(const Sensors& sensors, double seconds);

  struct Peak {
    double value = kUnknown;  // maximum; NaN: never measured
    double seconds = 0;       // time of the maximum
  };
  /// Difference between goal (after safety) and position, rad, of fresh measurements.
  [[nodiscard]] const Peak& error(Joint joint) const { return error_[index(joint)]; }
  /// Fraction of the maximum torque, 0 to 1.
  [[nodiscard]] const Peak& load(Joint joint) const { return load_[index(joint)]; }

  /// One line per joint: "Neck  1.2 deg at 0.48 s  load 31 % at 0.50 s".
  [[nodiscard]] std::string jointsText() const;
  /// Active faults by name, safety limits that cut goals, bus errors: one line each, or kNoFaults.
  [[nodiscard]] std::string faultsText() const;

 private:
  static void raise(Peak& peak, double value, double seconds);

  std::array<Peak, kJoints> error_{}, load_{};
  std::bitset<kFaults> faults_;
  std::optional<Sensors> first_;
  Sensors last_{};
};

}  // namespace darwinop::motion
