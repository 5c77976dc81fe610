// Fits of effects of joints and links to all limbs that they are in.
#pragma once

#include <functional>

#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/localize/body/clamped_robot.hpp"

namespace darwinop::gap {

/// A model of the robot's mechanics: effects in some joints and links.
struct MechanicsFit {
  std::vector<PlacedMechanics> effects;
  std::vector<std::vector<double>> sigmas;  // of their values; 0: not fitted
  double cost = 0;                          // of the limbs that were fitted: about one a sample, and the priors
  std::size_t numbers = 0;                  // that are free
};

/// The model with these effects.
BodyHypothesis with(const ClampedRobot& robot, const std::vector<PlacedMechanics>& effects);
/// Limbs that one of the effects is in, each once.
std::vector<std::size_t> limbsOf(const ClampedRobot& robot, const std::vector<PlacedMechanics>& effects);

/// Robust sum of squares.
double robustCost(const Eigen::VectorXd& whitened);
/// Weights of iteratively reweighted least squares for this cost.
Eigen::VectorXd robustWeights(const Eigen::VectorXd& whitened);

/// Residuals in standard deviations, with these effects.
using ResidualsOfEffects = std::function<Eigen::VectorXd(const std::vector<PlacedMechanics>&)>;

/// Most probable values of the effects from those given. `free`: indices of effects whose numbers are free; the others
/// stay. `secondary`: those numbers as well. `rows_alike`: residuals that count as one, for the standard deviations; of
/// kCorrelatedSamples, if it is less, the others are in the residuals already. What is left beyond noise widens them.
MechanicsFit fitEffects(const ResidualsOfEffects& residuals, std::vector<PlacedMechanics> effects,
                        const std::vector<std::size_t>& free, bool secondary, int iterations, double rows_alike);
/// The same, to the motion of the limbs that the free effects are in.
MechanicsFit fitMechanics(const ClampedRobot& robot, std::vector<PlacedMechanics> effects,
                          const std::vector<std::size_t>& free, bool secondary, int iterations);

}  // namespace darwinop::gap
