// Rivals over the rounds of a search.
#pragma once

#include <string_view>
#include <vector>

#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// Rivals of earlier effects, after one more round. Those whose own effect, the last, was `tested` again are gone: its
/// latest answer counts. The others are as undecided as before, beside the effect that was `added`; empty: none was.
void carryOn(std::vector<Rival>& rivals, const std::vector<std::string_view>& tested, std::string_view added);

}  // namespace darwinop::gap
