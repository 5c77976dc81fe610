// What was found in joints and links, for a terminal and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

/// "AnkleR", "AnkleR and AnkleL", "all joints".
std::string placesText(const std::vector<Joint>& joints);
/// "AnkleR", ["AnkleR", "AnkleL"] or "all".
nlohmann::ordered_json placesJson(const std::vector<Joint>& joints);

/// Lines of the answer.
std::string asText(const MechanicsSelection& selection);
/// Elements of `effects` and of `ambiguity` of an answer. `limbs`: a mass has its place in the frame of its link.
nlohmann::ordered_json effectJson(const FoundMechanics& one, const std::vector<Limb>& limbs);
nlohmann::ordered_json alternativesOf(const FoundMechanics& one);

}  // namespace darwinop::gap
