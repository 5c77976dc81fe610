// What a search has written: results.json or report.json.
#pragma once

#include <string>
#include <string_view>

#include "gap/identify/identification.hpp"
#include "gap/report/addition.hpp"

namespace darwinop::gap {

/// Of this case, from what `run --json` or `benchmark run` wrote. Throws std::runtime_error for a verdict that names
/// nothing.
Additions additionsIn(std::string_view results, const std::string& file, const Case& given);
/// A warning if report.json is of other recordings than these; empty: the same, or it has no hash.
std::string otherDataWarning(std::string_view results, const std::string& file, const std::string& data_hash);

/// Verdict, effects and rivals of this case, without their numbers: what a plan asks for. Throws std::runtime_error
/// with a sentence for what is not a report.json of `run`.
Identification identifiedIn(std::string_view report, const std::string& file, const Case& given);

}  // namespace darwinop::gap
