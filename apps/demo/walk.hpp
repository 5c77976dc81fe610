// `darwinop demo walk`: the twin stands up, walks, turns and stops, with measured distances.
#pragma once

#include "twin/view/show.hpp"

namespace darwinop::demo {

/// 0: done, or ended by the user; 1: it fell. Throws std::runtime_error.
int walk(const twin::ShowOptions& options);

}  // namespace darwinop::demo
