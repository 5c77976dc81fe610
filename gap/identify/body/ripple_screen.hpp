// Which torque ripples, how many a turn and in what phase, a linear model of a joint's position loop finds in what is
// left of its motion. A simulation of each count would take as long as the screen of all other effects together.
#pragma once

#include <vector>

#include "gap/identify/body/mechanics_screen.hpp"

namespace darwinop::gap {

/// Its numbers are amplitude, count and phase.
bool isRipple(const MechanicalEffect& effect);

/// Normal equations of sine and cosine of each count, per N m; index: the count.
struct RippleSums {
  Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
};
using RippleScan = std::vector<RippleSums>;

/// `left`: whitened residuals of the joint's limb about `now`.
RippleScan scanRipples(const ClampedRobot& robot, const BodyHypothesis& now, Joint joint, const Eigen::VectorXd& left);

/// Amplitude, count and phase of the ripples that explain most of all these joints together, no two counts neighbours.
std::vector<std::vector<double>> ripplesIn(const std::vector<const RippleScan*>& joints);

/// Simulated in each joint and pair of `sets`, or in all joints. `left`: whitened residuals of each limb; empty: none
/// in the limb are simulated.
std::vector<MechanicsCandidate> rippleCandidates(const ClampedRobot& robot, const BodyHypothesis& now,
                                                 const std::vector<std::vector<Joint>>& sets, ScreenedPlaces places,
                                                 const std::vector<Eigen::VectorXd>& left);

}  // namespace darwinop::gap
