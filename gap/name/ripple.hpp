// A ripple of the torque, looked for in short windows.
#pragma once

#include <vector>

#include "gap/name/screen.hpp"

namespace darwinop::gap {

/// The ripples that explain most of where short simulations from measured states end, the best first, without a
/// promise; none where nothing feels one, or the model has one. Over a whole log a strong ripple lets a released arm
/// rest in another dip, and nothing linear finds its count; a window of a tenth of a second knows no other dip.
std::vector<Probe> ripplesOf(const Settled& present);

}  // namespace darwinop::gap
