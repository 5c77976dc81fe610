// Candidates for the next effect of joints and links, fitted: evidence and rivals.
#pragma once

#include "gap/identify/body/mechanics_screen.hpp"
#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

struct MechanicsEntry {
  MechanicsFit fit;     // of all effects found, and of one more
  double evidence = 0;  // gain of the cost less the prices
  double gain = 0;
};

std::vector<PlacedMechanics> effectsOf(const std::vector<FoundMechanics>& found);
/// Robust cost of these limbs.
double costOf(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& hypothesis);

/// Candidates of the screen, fitted; best first. Mass and centre of mass of the best link are both among them.
std::vector<MechanicsEntry> fitted(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                   const std::vector<MechanicsCandidate>& candidates);
/// Names that the data do not exclude beside the best of these entries.
std::vector<PlacedMechanics> rivalsOf(const std::vector<MechanicsEntry>& entries);

}  // namespace darwinop::gap
