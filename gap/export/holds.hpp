// The table of what each target can hold: one row an effect, by its facet, and one for each number of a servo that a
// target may lack. Exports, their lists of losses and docs/gap/export.md are made from it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gap/export/target.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

using twin::Fate;
using twin::Holding;

/// Name of the row of a servo whose P sets its duty.
inline constexpr const char* kPOnTorque = "P on torque (law voltage_p)";
inline constexpr std::string_view kArmature = "armature", kEncoderSteps = "encoder's steps";

struct HoldingRow {
  std::string_view what;  // id of an effect, or "back EMF"
  std::array<Holding, kTargets> by_target;
  /// Of a number: whether this servo has it. Null for effects.
  bool (*applies)(const Hypothesis& hypothesis) = nullptr;

  [[nodiscard]] const Holding& of(Target target) const { return by_target[static_cast<std::size_t>(target)]; }
};

std::vector<HoldingRow> effectHoldings();  // in the order of the catalogue
std::span<const HoldingRow> numberHoldings();
HoldingRow holdingOf(const twin::EffectInfo& effect);

std::string_view name(Fate fate);
/// One line per target: which of the rows it holds, approximates and loses.
std::string holdingTable(std::string_view what, std::span<const HoldingRow> rows, std::string_view quote);
/// Two tables in Markdown, effects and numbers by target and fate; `how` is in each exported file.
std::string holdingsAsMarkdown();

}  // namespace darwinop::gap
