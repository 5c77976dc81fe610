// Additions to a model file: effects, changed numbers, and their evidence.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// A value of an effect's parameter. The interval holds the truth in nine of ten cases; NaN: unknown.
struct AddedValue {
  std::string key;  // "friction"
  double value = 0, low = 0, high = 0;

  /// The interval of the answer, moved `by` the model's value less the answer's: half a firmware period for a delay,
  /// which the model counts from the firmware's next period.
  void setInterval(double found_low, double found_high, double by) { low = found_low + by, high = found_high + by; }
};

/// One effect. Parameters that are not given stay as the model has them; else they are typical, and a comment says so.
struct AddedEffect {
  std::string id;
  std::vector<AddedValue> values;
  std::vector<std::string> because;  // comments above its section
  std::vector<Joint> joints = {};    // of a robot; empty: all, also those with a section of their own
};

/// Another number of the model: one that a fit has moved inside its prior, or that was found to be wrong.
struct AddedNumber {
  std::string key;  // "kt" of the section, "viscous.damping" of an effect that the model has
  double value = 0;
  std::string section = "servo";
  std::optional<Joint> joint = {};  // in the sections of that joint, if effects have it
};

/// A key with a number for x, y and z.
struct AddedAxes {
  std::string section, key;
  std::array<double, 3> values{};
};

struct Additions {
  std::vector<AddedNumber> numbers;
  std::vector<AddedAxes> axes = {};
  std::vector<AddedEffect> effects;
};

/// Of the servo of the joint of this case, which has sections of its own then. A mass of all that it carries becomes
/// that of each link outwards of it, with a shift as mass of equal moment. A case without joint: the same. Throws
/// std::runtime_error for a shift without mass.
Additions atJoint(Additions additions, const Case& given);
/// "coulomb.friction=0.05"; several of one effect belong together. Throws std::runtime_error with a sentence.
Additions additionsFrom(const std::vector<std::string>& texts);
/// The model file `text` with them; everything else in it stays. Throws std::runtime_error with a sentence for an
/// effect or parameter that does not exist, and for an impossible value.
std::string withAdditions(std::string text, const Additions& additions);
/// A line for each section of the model file that they add or replace, and for each number of all joints.
std::vector<std::string> changesBy(const Additions& additions, const twin::Model& before);

}  // namespace darwinop::gap
