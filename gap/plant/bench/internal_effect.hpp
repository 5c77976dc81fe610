// Effects inside a simulated servo that are not in the catalogue: given drives, noise, unmodelled effects of
// benchmarks.
#pragma once

#include <memory>
#include <span>

#include "twin/servo/effect.hpp"

namespace darwinop::gap {

/// It is never identified, fitted or written into a model, so it has no equation, no parameters and no factory.
inline twin::EffectInfo internalEffect(std::string_view id, std::string_view title, twin::LoopPart part) {
  const auto no_factory = [](std::span<const double>) { return std::unique_ptr<twin::Effect>{}; };
  return twin::EffectInfo{{.id = id,
                           .title = title,
                           .part = part,
                           .equation = "",
                           .signature = "",
                           .separated_by = "",
                           .source = "",
                           .confused_with = {},
                           .parameters = {},
                           .laws = twin::Laws::kBoth,
                           .visibility = twin::Visibility::kFirmwareOnly,
                           .revealed_by = {},
                           .prevalence = twin::Prevalence::kRare,
                           .aliases = {},
                           .step_demand = twin::StepDemand::kNone,
                           .synthetic = {},
                           .exports = twin::inAllFormats(twin::lost("")),
                           .other_names = {},
                           .make = no_factory}};
}

}  // namespace darwinop::gap
