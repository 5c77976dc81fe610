// The name of a section of a model file: one of the four plain ones, or that of an effect.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

struct SectionName {
  std::string_view plain = {};       // "servo"; empty: an effect
  const EffectInfo* info = nullptr;  // of an effect
  std::optional<Joint> joint = {};   // of an effect: nothing is all joints
  friend bool operator==(const SectionName&, const SectionName&) = default;
};

/// "servo", "effect coulomb", "effect coulomb Neck", in any case. Throws std::runtime_error, a sentence with what there
/// is.
SectionName sectionFrom(std::string_view text);
/// As it is written: "effect coulomb Neck".
std::string text(const SectionName& name);

std::vector<std::string_view> effectIds();
std::vector<std::string_view> parametersOf(const EffectInfo& info);

}  // namespace darwinop::twin
