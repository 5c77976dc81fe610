// A robot whose trunk is clamped: its limbs, and the noise of each about one model of it.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "gap/localize/body/limb_residuals.hpp"

namespace darwinop::gap {

class ClampedRobot {
 public:
  /// Throws std::runtime_error where the body has limbs that cannot be simulated.
  /// `has_board_supply`: as in BodyHypothesis, even if the model's battery has no resistance.
  explicit ClampedRobot(const BodyCase& given, bool has_board_supply = false);

  /// There is a log with a clamped trunk, and the servos' law can be simulated.
  [[nodiscard]] bool isTestable() const { return is_testable_; }
  [[nodiscard]] const BodyCase& given() const { return given_; }
  [[nodiscard]] const std::vector<Limb>& limbs() const { return limbs_; }
  [[nodiscard]] const BodyHypothesis& baseline() const { return baseline_; }
  [[nodiscard]] const LimbResiduals& residuals(std::size_t limb) const { return *residuals_[limb]; }
  [[nodiscard]] std::size_t limbOf(Joint joint) const { return limb_of_[static_cast<std::size_t>(joint)]; }

  /// Estimates the noise of these limbs about this model.
  void renew(const std::vector<std::size_t>& limbs, const BodyHypothesis& about);
  /// Returns what was in its place.
  std::unique_ptr<LimbResiduals> replace(std::size_t limb, std::unique_ptr<LimbResiduals> by) {
    std::swap(residuals_[limb], by);
    return by;
  }

 private:
  const BodyCase& given_;
  std::vector<Limb> limbs_;
  BodyHypothesis baseline_;
  bool is_testable_;
  std::vector<std::unique_ptr<LimbResiduals>> residuals_;
  std::array<std::size_t, kJoints> limb_of_{};
};

}  // namespace darwinop::gap
