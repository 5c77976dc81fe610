// Messages of the live comparison's channel. From a page:
//   {"run": {"model": "repaired.ini", "support": "clamped"}}   {"run": null}
// To it: {"type": "comparison", ...} several times a second; unknown values are null, never 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "window/live/live_thread.hpp"

namespace darwinop::window {

inline constexpr const char* kLiveProtocol = "darwinop-live.1";

struct LiveRequest {
  std::optional<LiveSetting> run;  // none: stop
};

/// Nullopt: invalid, with the reason in `why`.
[[nodiscard]] std::optional<LiveRequest> parseLiveRequest(std::string_view text, std::string& why);

[[nodiscard]] std::string liveText(const LiveStatus& status);

}  // namespace darwinop::window
