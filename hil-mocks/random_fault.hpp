// Draws a fault of a given kind.
#pragma once

#include "core/random.hpp"
#include "hil-mocks/fault.hpp"

namespace darwinop::hil {

/// A fault that begins at `at`, with random duration, servos and amounts.
[[nodiscard]] InjectedFault randomFault(FaultKind kind, Nanos at, Rng& random) noexcept;

}  // namespace darwinop::hil
