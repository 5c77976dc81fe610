// Search on half of a session, tested on the rest: where no model explains all logs, one may explain some of them down
// to the noise.
#pragma once

#include <functional>
#include <optional>

#include "gap/identify/identification.hpp"

namespace darwinop::gap {

using Search = std::function<Identification(const Study&, const IdentifyOptions&)>;

/// `search` on the first and on the last half of the fit logs, by session time. Its effects are accepted if it leaves
/// nothing but noise in its half, and each of them improves the prediction of the logs outside of that half. Then the
/// other logs have a remainder. Nothing: neither half has such an effect, or there are fewer than six logs.
std::optional<Identification> searchInHalves(const Study& study, const IdentifyOptions& options, const Search& search);

}  // namespace darwinop::gap
