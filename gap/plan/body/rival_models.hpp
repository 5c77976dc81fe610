// Models of the whole robot that its recordings do not separate.
#pragma once

#include <string>
#include <vector>

#include "gap/identify/body/body_identification.hpp"

namespace darwinop::gap {

struct RivalModel {
  std::string name;  // "floor_tilt floor", "nothing missing"
  FloorModel model;
};

struct BodyQuestion {
  /// True: the models compete. False: would the effects of the models after the first show?
  bool is_rivalry = true;
  std::vector<RivalModel> models;  // what was found first
};

/// Ambiguous: what was found and its rivals. Unknown: what was tried, and no name. Else, or where nothing was tried:
/// each effect of sensor, floor and trunk in the size from which a search begins.
BodyQuestion questionAfter(const BodyCase& given, const BodyIdentification& found);

}  // namespace darwinop::gap
