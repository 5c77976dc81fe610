// Mirrors a page: swaps left and right.
#pragma once

#include "managers/motion/page.hpp"

namespace darwinop::motion {

/// Swaps positions and slopes of left and right and mirrors positions to 4096 - tick. The head's pan is mirrored, its
/// tilt is not. Flags are swapped unchanged. Mirroring twice gives the same page, except for tick 0, whose mirror 4096
/// is clamped to 4095.
[[nodiscard]] Page mirrored(const Page& page);

}  // namespace darwinop::motion
