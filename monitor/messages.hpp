// The texts of the channel, docs/monitor.md. Whatever is not known is null, never 0.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/sensors.hpp"
#include "monitor/wishes.hpp"
#include "runtime/exchange.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::monitor {

inline constexpr const char* kSubprotocol = "darwinop-monitor.1";

/// What an observer said. Nothing, and `why`: it was not understood. A member that is left out keeps its value.
[[nodiscard]] std::optional<Wishes> readWishes(std::string_view text, const Wishes& before, std::string& why);

/// `info`: nothing while there is no runtime.
[[nodiscard]] std::string helloText(const runtime::LoopInfo* info, const Wishes& wishes);

[[nodiscard]] std::string stateText(const Sensors& seen);

struct LoopFigures {
  const runtime::StatsView& all;     // since the loop began
  const runtime::StatsView& recent;  // since the message before
  double seconds = 0;                // between the two
  pid_t driver = 0;                  // 0: nobody, -1: of another user
  std::uint32_t session = 0;
  std::uint64_t lost = 0;  // messages that this observer was too slow for
};
[[nodiscard]] std::string loopText(const LoopFigures& figures, const Sensors& seen);

[[nodiscard]] std::string faultsText(const SafetyReport& safety);
/// `time`: s on the loop's clock, NaN without one.
[[nodiscard]] std::string noticeText(std::uint64_t number, double time, const std::string& text);
[[nodiscard]] std::string goneText(const std::string& reason);
[[nodiscard]] std::string cameraText(bool seeing, const std::string& text);
[[nodiscard]] std::string errorText(const std::string& text);

}  // namespace darwinop::monitor
