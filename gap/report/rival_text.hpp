// A rival beside what was found.
#pragma once

#include <string>
#include <vector>

#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// The rival has all that was found, and these; empty: it is in place of something.
std::vector<std::string> addedBy(const Rival& rival, const Identification& identification);
/// Of a rival by prediction: what logs that are not fitted say.
const char* predictionOf(const Rival& rival, const Identification& identification);

}  // namespace darwinop::gap
