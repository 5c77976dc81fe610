// Picture of the robot as inline SVG, from the front and from its left: every place in the colour of what was found.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "twin/model/model.hpp"

namespace darwinop::gap {

enum class PlaceState : std::uint8_t { kUntested, kAgrees, kDiverges, kPossible, kNamed };

/// Class of the style sheet: "agrees".
std::string_view nameOf(PlaceState state);

struct PlaceMark {
  PlaceState state = PlaceState::kUntested;
  std::vector<std::string> labels = {};  // beside the place, a line each: "coulomb"
};

inline constexpr std::string_view kFloorPlace = "floor";

/// By link ("AnkleR", "Body"), "gyro", "accelerometer", "battery" or kFloorPlace; labels of any other key begin at the
/// trunk.
using PlaceMarks = std::map<std::string, PlaceMark, std::less<>>;

/// At joint angles of zero; empty where the model's body has nothing to draw. Throws std::runtime_error where it cannot
/// be read.
std::string robotPicture(const twin::Model& model, const PlaceMarks& marks);

}  // namespace darwinop::gap
