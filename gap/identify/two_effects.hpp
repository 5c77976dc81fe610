// On a roughly known baseline: do two effects explain all?
#pragma once

#include <optional>

#include "gap/identify/fitted_model.hpp"
#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// At most two effects, the numbers of the baseline free.
struct TwoEffects {
  std::optional<Identification> explained;  // if they leave only noise
  FittedModel firmware;                     // those of them that are effects of the firmware
};

/// Searches the logs of `few`, which may be `study`; what leaves only noise there is fitted to all of `study`. All must
/// outlive the result.
TwoEffects searchTwoEffects(const Study& study, const Study& few, IdentifyOptions options);

}  // namespace darwinop::gap
