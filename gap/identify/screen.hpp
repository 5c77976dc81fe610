// Predicts the gain of every candidate effect before any fit: one simulation each at a few values of its parameters,
// the rest by linear algebra.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/identify/fitted_model.hpp"

namespace darwinop::gap {

/// One effect at one set of parameter values.
struct Candidate {
  const twin::EffectInfo* effect = nullptr;
  std::vector<double> values;  // of the unknowns of the effect, in their units
  double predicted_gain = 0;   // cost that it is predicted to remove
};

struct CandidatePair {
  Candidate one, other;
  double predicted_gain = 0;
};

/// A candidate moved to where its effect explains most, as far as that can be predicted without a fit.
struct RefinedStart {
  Candidate candidate;  // its gain: with the numbers of the present model moving linearly
  Eigen::VectorXd x;    // of the problem with the effect: where a fit starts
};

class Screen {
 public:
  /// `present` must have a Jacobian and outlive this. Simulates every effect that it does not have.
  Screen(const FittedModel& present, const std::vector<const twin::EffectInfo*>& effects);

  [[nodiscard]] bool hasRipples() const;
  /// All candidates with their predicted gains, greatest first.
  [[nodiscard]] std::vector<Candidate> candidates() const;
  /// The best pair of candidates of each two effects, greatest predicted gain first; ripples are left out.
  [[nodiscard]] std::vector<CandidatePair> pairs() const;
  [[nodiscard]] RefinedStart refinedStart(const Candidate& candidate) const;
  /// The greatest predicted gain of any candidate if the residuals were these: for the bootstrap.
  [[nodiscard]] double greatestPredictedGain(const Eigen::VectorXd& residuals) const;

 private:
  struct Direction {
    Candidate candidate;
    Eigen::MatrixXd change;   // of the residuals, without what the unknowns of the present model can explain
    bool either_way = false;  // two columns: amplitude and phase of a ripple
  };
  static constexpr double kLeastChange = 1e-9;  // squares of a change below which nothing changes
  [[nodiscard]] double predictedGain(const Direction& direction, const Eigen::VectorXd& residuals) const;

  [[nodiscard]] Eigen::VectorXd withoutAbsorbed(Eigen::VectorXd extended) const;

  const FittedModel& present_;
  Eigen::MatrixXd jacobian_;  // of the present model's unknowns, priors included
  Eigen::MatrixXd absorbed_;  // orthonormal: what the unknowns of the present model can explain, priors included
  Eigen::VectorXd residuals_;
  std::vector<Direction> directions_;
};

}  // namespace darwinop::gap
