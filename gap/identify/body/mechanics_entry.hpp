// Candidates for the next effect of joints and links, fitted: evidence and rivals.
#pragma once

#include "gap/identify/body/mechanics_screen.hpp"
#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

struct MechanicsEntry {
  MechanicsFit fit;     // of all effects found, and of one more
  double evidence = 0;  // gain of the cost less the prices
  double gain = 0;

  [[nodiscard]] const PlacedMechanics& placed() const { return fit.effects.back(); }
};

std::vector<PlacedMechanics> effectsOf(const std::vector<FoundMechanics>& found);
/// Sets `own`: what the model and the effects before an addition give each of its joints. No more is taken away.
void setOwn(BodyHypothesis robot, std::vector<FoundMechanics>& found);
/// Robust cost of these limbs.
double costOf(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& hypothesis);
/// Cost that an effect has to remove to be worth its name and so many free numbers.
double priceOf(const ClampedRobot& robot, const PlacedMechanics& placed, std::size_t numbers);
/// One of the effect's joints is in one of the limbs.
bool isInOneOf(const ClampedRobot& robot, const PlacedMechanics& effect, const std::vector<std::size_t>& limbs);

/// Of what is found and, fitted from there, this effect.
MechanicsEntry fittedFrom(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                          const PlacedMechanics& start);
/// Sorted entries: indices of those that are the first of a limb.
std::vector<std::size_t> bestOfLimbs(const ClampedRobot& robot, const std::vector<MechanicsEntry>& entries);

/// Candidates that are worth a fit, by predicted gain less the prices of their names and numbers: the best of all, and
/// the best few of each limb. Of mass and centre of mass of a link, the better one.
std::vector<MechanicsCandidate> shortlist(const ClampedRobot& robot, std::vector<MechanicsCandidate> candidates);

/// The shortlist of a screen, fitted; best first. Mass and centre of mass of a limb's best link are both among them.
std::vector<MechanicsEntry> fitted(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                   const std::vector<MechanicsCandidate>& candidates);
/// Names that the data do not exclude beside the first of these entries.
std::vector<PlacedMechanics> rivalsOf(const std::vector<MechanicsEntry>& entries);

}  // namespace darwinop::gap
