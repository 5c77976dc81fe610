// Corrupts the bytes of one frame.
#pragma once

#include "hil-mocks/chunk.hpp"
#include "hil-mocks/fault.hpp"
#include "hil-mocks/random.hpp"

namespace darwinop::hil {

/// Drops, corrupts or repeats `fault.amount` bytes at random positions, repeats or delays the frame, or puts garbage
/// before it. The chunk may become empty.
void spoil(Chunk& chunk, const Fault& fault, Random& random) noexcept;

/// Sets the fault's error bits in a status of one of its servos, with the fault's chance; the checksum stays valid.
void flicker(Chunk& chunk, const Fault& fault, Random& random) noexcept;

}  // namespace darwinop::hil
