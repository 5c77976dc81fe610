// What is said of one case.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace darwinop::gap {

/// All of a run on the case in `folder`, under the folder's name; its time is how long it took. What goes wrong is an
/// answer, too: verdict `bad_input` when the case cannot be used, `error` when the fault is ours, and `why`.
nlohmann::json answerFor(const std::string& folder);

/// Tells one content of case.json from another: the same name in another battery is another case. Empty: unreadable.
std::string fingerprintOf(const std::string& folder);

/// "e07  named coulomb + backlash  31.00 -> 0.90 mrad  12.3 s", at most 100 columns.
std::string lineOf(const nlohmann::json& answer);

}  // namespace darwinop::gap
