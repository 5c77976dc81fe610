// How far the residual of a block moves the joint: blocks in ticks, volts and radians become comparable.
#pragma once

#include <vector>

#include "gap/localize/blocks.hpp"

namespace darwinop::gap {

/// Fills effect_rad and share of all open blocks, and `first`.
void rankBlocks(const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs, Blocks& blocks);

}  // namespace darwinop::gap
