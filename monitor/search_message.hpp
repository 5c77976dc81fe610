// What is to be found in the pictures, and what was found, as texts of the channel.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "monitor/wishes.hpp"

namespace darwinop::monitor {

/// The member `find` of what an observer said, if there is one. Empty: understood; else why not, and `wishes` is as it
/// was.
[[nodiscard]] std::string takeSearch(const nlohmann::ordered_json& asked, Wishes& wishes);
/// What takeSearch() understands, for another monitor.
[[nodiscard]] nlohmann::ordered_json searchJson(const Wishes& wishes);

[[nodiscard]] std::string foundText(const Found& found, bool mask);

}  // namespace darwinop::monitor
