// Section names of a model file: [model], [servo], [body], [imu], a link, or an effect.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

struct SectionName {
  std::string_view plain = {};       // "servo", "link Body"; empty for an effect
  const EffectInfo* info = nullptr;  // null for a plain section
  std::optional<Joint> joint = {};   // empty: all joints
  friend bool operator==(const SectionName&, const SectionName&) = default;
};

/// "servo", "link Body", "effect coulomb", "effect coulomb Neck", case-insensitive. Throws std::runtime_error with a
/// suggestion.
SectionName sectionFrom(std::string_view text);
/// Canonical spelling: "effect coulomb Neck".
std::string text(const SectionName& name);

std::vector<std::string_view> effectIds();
std::vector<std::string_view> parametersOf(const EffectInfo& info);

}  // namespace darwinop::twin
