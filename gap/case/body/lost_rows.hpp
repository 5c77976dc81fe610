// Rows that a recording of the whole robot has lost: their goals are not known, and the servos had others.
#pragma once

#include <cstddef>
#include <span>

#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kRowsLost =
    " rows are lost (gaps in `cycle`); what servos read right after several of them is left out";
inline constexpr const char* kLongHole = " are lost before this row; cut there with from_s and to_s, or record again";
}  // namespace messages

/// By the gaps in `cycle`, or by the note of the recorder.
std::size_t lostRows(const logs::Log& recording);

/// Forgets positions and loads of the joints after several lost rows, until their goals no longer matter. `joints`: of
/// this recording. Throws BadInput for a hole that is too long for that.
void forgetAfterLostRows(const logs::Log& recording, std::span<Trajectory> joints);

}  // namespace darwinop::gap
