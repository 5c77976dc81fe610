// Findings of the 2013 thesis that need the whole robot, as cases with given effects: docs/gap/thesis.md.
#pragma once

#include <cstdint>
#include <vector>

#include "gap/benchmark/body/body_suite.hpp"

namespace darwinop::gap {

/// t5: mirrored accelerometer. t6: bow test. t9a to t9m: gyroscope of a walk, by one of the causes that were tried
/// then; the last one has none. `seed`: of motions and noise.
std::vector<BodyRequest> thesisRequests(std::uint64_t seed);

}  // namespace darwinop::gap
