// Columns of a joint that are those of another joint, or have the other sign: what a servo reads and what it is
// commanded are tied by its control law, so the law shows which column fits.
#pragma once

#include <cstddef>
#include <string>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kFitsOtherColumn = " fits the control law of ";
inline constexpr const char* kOtherSign = " with the other sign";
}  // namespace messages

/// Throws BadInput, a sentence with file and column, where the law plainly contradicts a joint as it is recorded and
/// plainly agrees with one other column. An effect of the robot never does: it leaves a residual with every column.
/// Law voltage_p only.
void refuseExchangedColumns(const BodyCase& given, std::size_t log);

}  // namespace darwinop::gap
