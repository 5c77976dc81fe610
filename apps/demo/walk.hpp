// `darwinop demo walk`: the twin stands up, walks, turns and stops, in a film or window, with measured distances.
#pragma once

#include "twin/view/show.hpp"

namespace darwinop::demo {

inline constexpr const char* kStanceReached = "stance reached";  // printed before the first step

/// Exit code: 0 completed or ended by the user, 1 fell. Throws std::runtime_error.
int walk(const twin::ShowOptions& options);

}  // namespace darwinop::demo
