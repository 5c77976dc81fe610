// Messages of the colour search: the request member `find` and the result "found".
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "monitor/subscription.hpp"

namespace darwinop::monitor {

/// Reads the member `find` of a request, if present. Returns an error text and leaves `subscription` unchanged, or an
/// empty string.
[[nodiscard]] std::string takeSearch(const nlohmann::ordered_json& request, Subscription& subscription);
/// The inverse of takeSearch(), for a request to another monitor.
[[nodiscard]] nlohmann::ordered_json searchJson(const Subscription& subscription);

[[nodiscard]] std::string colourMatchText(const ColourMatch& found, bool mask);

}  // namespace darwinop::monitor
