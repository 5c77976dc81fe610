// `darwinop demo walk`: the twin gets up, walks, turns and stops, seen in a film or a window, with figures.
#pragma once

#include "twin/view/show.hpp"

namespace darwinop::demo {

/// 0: it did, or was ended on the way; 1: it fell. Throws std::runtime_error.
int walk(const twin::ShowOptions& options);

}  // namespace darwinop::demo
