// Search on half of a session, tested on the rest: where no model explains all logs, one may explain some of them down
// to the noise.
#pragma once

#include <optional>

#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// A search on the first and on the last half of the fit logs, by session time. Its effects are accepted if they leave
/// nothing but noise in their half, and each of them improves the prediction of the logs outside of that half. Then the
/// other logs have a remainder. Nothing: neither half has such an effect, or there are fewer than six logs.
std::optional<Identification> searchInHalves(const Study& study, const IdentifyOptions& options);

}  // namespace darwinop::gap
