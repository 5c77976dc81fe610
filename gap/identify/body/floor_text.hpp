// What was found in floor, trunk and moving sensor, for a terminal and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/identify/body/floor_selection.hpp"

namespace darwinop::gap {

/// Begins the line of an effect that explains more than chance and has no name.
inline constexpr const char* kNotNamed = "  nearest, and no name: ";

/// Lines of the answer.
std::string asText(const FloorSelection& selection);
/// Elements of `effects` and of `ambiguity` of an answer.
nlohmann::ordered_json effectJson(const FoundFloor& one);
nlohmann::ordered_json alternativesOf(const FoundFloor& one);

}  // namespace darwinop::gap
