// `darwinop demo walk`: the twin stands up, walks, turns and stops, in a film or window, with measured distances.
#pragma once

#include "twin/view/show.hpp"

namespace darwinop::demo {

/// Exit code: 0 completed or ended by the user, 1 fell. Throws std::runtime_error.
int walk(const twin::ShowOptions& options);

}  // namespace darwinop::demo
