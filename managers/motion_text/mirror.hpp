// A page for the other side of the body: left and right swapped.
#pragma once

#include "managers/motion/page.hpp"

namespace darwinop::motion {

/// Positions and slopes of left and right change places; the sign is that of core/joints.hpp: 4096 - tick. The head
/// pans to the other side and tilts as before. Words that are no position move as they are. Twice is the same page
/// again, but for tick 0: its mirror would be 4096, and becomes 4095.
[[nodiscard]] Page mirrored(const Page& page);

}  // namespace darwinop::motion
