// Looks at every cycle of a movement, and says at its end what it did to the robot.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <string>

#include "core/sensors.hpp"

namespace darwinop::motion {

class MotionWatch {
 public:
  /// `seconds` since the movement began. Counters are told as what they have grown by since the first look.
  void look(const Sensors& sensors, double seconds);

  struct Peak {
    double value = kUnknown;  // the greatest there was; NaN: never measured
    double seconds = 0;       // when
  };
  /// rad between goal, after safety, and position; of fresh measurements alone.
  [[nodiscard]] const Peak& error(Joint joint) const { return error_[index(joint)]; }
  /// Fraction of the greatest torque, 0 to 1.
  [[nodiscard]] const Peak& load(Joint joint) const { return load_[index(joint)]; }

  /// A line a joint: "Neck  1.2 deg at 0.48 s  load 31 % at 0.50 s".
  [[nodiscard]] std::string jointsText() const;
  /// Faults that were there, by name; limits of the safety layer that cut goals; what was lost on the bus. One line
  /// each; "no faults" when there is nothing to tell.
  [[nodiscard]] std::string faultsText() const;

 private:
  static void raise(Peak& peak, double value, double seconds);

  std::array<Peak, kJoints> error_{}, load_{};
  std::bitset<kFaults> faults_;
  std::optional<Sensors> first_;
  Sensors last_{};
};

}  // namespace darwinop::motion
