// Corrupts the bytes of one frame.
#pragma once

#include "core/random.hpp"
#include "hil-mocks/chunk.hpp"
#include "hil-mocks/fault.hpp"

namespace darwinop::hil {

/// Drops, corrupts or repeats `fault.amount` bytes at random positions, repeats or delays the frame, or puts garbage
/// before it. The chunk may become empty.
void spoil(Chunk& chunk, const InjectedFault& fault, Rng& random) noexcept;

/// Sets the fault's error bits in a status of one of its servos, with the fault's chance; the checksum stays valid.
void flicker(Chunk& chunk, const InjectedFault& fault, Rng& random) noexcept;

}  // namespace darwinop::hil
