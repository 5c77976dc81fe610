// The result of one case.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace darwinop::gap {

/// Investigates the case in `folder`; the folder's name is the name of the case. Errors are results as well: verdict
/// `bad_input` for a case that cannot be used, `error` for an internal error, and `why`.
nlohmann::json answerFor(const std::string& folder);

/// Hash of case.json and the logs that it names: two suites may use one name for different cases. Empty: no case.json
/// can be read.
std::string fingerprintOf(const std::string& folder);

/// "e07  named coulomb + backlash  31.00 -> 0.90 mrad  12.3 s", at most 100 columns.
std::string lineOf(const nlohmann::json& answer);

}  // namespace darwinop::gap
