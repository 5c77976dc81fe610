// Looks at every suspect before any fit: one run each at a few values of its parameters, the rest by linear algebra.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "gap/name/settled.hpp"

namespace darwinop::gap {

inline constexpr int kMostRipples = 60;  // a turn, of a cogging that is looked for

/// One try of one effect.
struct Probe {
  const twin::EffectInfo* effect = nullptr;
  std::vector<double> values;  // of the unknowns of the effect, in their units
  double promise = 0;          // cost that it may take away
};

/// A probe that has been moved to where its effect explains most, as far as can be told without a fit.
struct Sharpened {
  Probe probe;        // its promise: what it takes away with the numbers of the present model moving linearly
  Eigen::VectorXd x;  // of the problem with the effect: where a fit should start
};

class Screen {
 public:
  /// `present`: with slopes; it has to outlive this. Runs every suspect that it does not have.
  Screen(const Settled& present, const std::vector<const twin::EffectInfo*>& suspects);

  [[nodiscard]] bool suspects(std::string_view effect) const;
  /// What each probe promises for the present residuals.
  [[nodiscard]] std::vector<Probe> probes() const;
  [[nodiscard]] Sharpened sharpened(const Probe& probe, int iterations = 5) const;
  /// The greatest promise of any probe if the residuals were these: for the distribution of false promises.
  [[nodiscard]] double greatestPromise(const Eigen::VectorXd& residuals) const;

 private:
  struct Direction {
    Probe probe;
    Eigen::MatrixXd change;   // of the residuals by the probe, without what the unknowns of the present model can do
    bool either_way = false;  // two columns: amplitude and phase of a ripple
  };
  [[nodiscard]] double promise(const Direction& direction, const Eigen::VectorXd& residuals) const;

  [[nodiscard]] Eigen::VectorXd withoutAbsorbed(Eigen::VectorXd extended) const;

  const Settled& present_;
  Eigen::MatrixXd slopes_;    // of the present model's unknowns, priors included
  Eigen::MatrixXd absorbed_;  // orthonormal: what the unknowns of the present model can take away, priors included
  Eigen::VectorXd residuals_;
  std::vector<Direction> directions_;
};

}  // namespace darwinop::gap
