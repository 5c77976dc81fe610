// What each target can hold of the keys of a robot's model file beside its servos.
#pragma once

#include <span>
#include <string>

#include "gap/export/holds.hpp"
#include "gap/export/targets.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

struct KeyHolding {
  std::string_view section;  // "body", "imu", "link"
  HoldingRow row;            // `what`: the key
};
std::span<const KeyHolding> keyHoldings();

/// Sentences of what a target loses or approximates of this model: keys that differ from their defaults, and effects of
/// servos, each once with its joints.
void addBodyLosses(Target target, const twin::Model& model, Export& out);

/// By target and fate, as holdingsAsMarkdown().
std::string keyHoldingsAsMarkdown();

}  // namespace darwinop::gap
