// What acts inside a simulated servo and is no effect of the catalogue: given drives, noise of the bench, strangers.
#pragma once

#include <memory>
#include <span>

#include "twin/servo/effect.hpp"

namespace darwinop::gap {

/// Nobody names it, fits it or writes it into a model, so it has no equation, no parameters and no maker.
inline twin::EffectInfo internalEffect(std::string_view id, std::string_view title, twin::Place place) {
  const auto nobody_makes_it = [](std::span<const double>) { return std::unique_ptr<twin::Effect>{}; };
  return {.id = id,
          .title = title,
          .place = place,
          .equation = "",
          .signature = "",
          .separated_by = "",
          .source = "",
          .confused_with = {},
          .parameters = {},
          .make = nobody_makes_it};
}

}  // namespace darwinop::gap
