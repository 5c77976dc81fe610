// Lone readings that a servo cannot have made: a register that came back as 0, a telegram read wrongly, an old answer
// read again. They are masked, which is NaN in the log, and counted.
#pragma once

#include <string>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Greatest share of the rows of a log in which a column may have no usable reading, or a recording no answer. Bad rows
/// of logs that other people share are some in a thousand; a servo that loses a tenth has another fault, which the
/// readings that are left may share. How a fit degrades below that share is not measured.
inline constexpr double kMostMasked = 0.1;

/// Masks readings of position, speed, load, voltage and temperature. `file` is used in messages. Throws BadInput where
/// more than kMostMasked of a column is out of its physical range, masked by all checks together, or not there although
/// the log needs it.
void maskBadRows(Trajectory& log, const std::string& file, const Case& c);

/// "fit_1.csv: 2 of 600 readings of pos are masked, the first in line 302: they jump and come back".
std::string asSentence(const Trajectory& log, const MaskedReadings& masked);

}  // namespace darwinop::gap
