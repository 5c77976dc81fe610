// Measured minus expected load of each joint, whose control law gets the measured position: nothing that the joint
// moves matters, and nothing is simulated.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "gap/case/body/body_case.hpp"
#include "gap/fit/unknown.hpp"

namespace darwinop::gap {

class ControllerResiduals {
 public:
  /// Of all recordings that are held out, or of the others.
  ControllerResiduals(const BodyCase& given, bool held_out);

  /// In standard deviations, thinned to independent samples: the sum of squares is one each if the law is right. An
  /// error of the gain inside its prior counts once. Empty where no load is known.
  [[nodiscard]] Eigen::VectorXd of(Joint joint, const Hypothesis& servos) const;
  /// Standard deviations of a normal distribution.
  [[nodiscard]] double significance(Joint joint, const Hypothesis& servos) const;

 private:
  struct Samples {
    std::vector<std::size_t> logs;  // in BodyCase::joints
    Eigen::VectorXd sigma;          // of the model as it is; infinity: not known
    double count = 0;               // that are known
  };
  [[nodiscard]] Eigen::VectorXd raw(const Samples& samples, const Hypothesis& servos) const;

  const BodyCase& given_;
  std::array<Samples, kJoints> joints_;
  std::optional<Unknown> gain_;
};

}  // namespace darwinop::gap
