// Messages of the monitor channel (docs/monitor.md). Unknown values are null, never 0.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/sensors.hpp"
#include "monitor/subscription.hpp"
#include "runtime/exchange.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::monitor {

inline constexpr const char* kSubprotocol = "darwinop-monitor.1";

/// Parses an observer's request. Nullopt: invalid, with the reason in `why`. An omitted member keeps its value.
[[nodiscard]] std::optional<Subscription> parseSubscription(std::string_view text, const Subscription& before,
                                                            std::string& why);

/// `info`: null while no runtime is running.
[[nodiscard]] std::string helloText(const runtime::LoopInfo* info, const Subscription& subscription);

[[nodiscard]] std::string stateText(const Sensors& seen);

struct LoopFigures {
  const runtime::StatsView& all;     // since the loop started
  const runtime::StatsView& recent;  // since the previous message
  double seconds = 0;                // between the two messages
  pid_t driver = 0;                  // 0: none, -1: a process of another user
  std::uint32_t session = 0;
  std::uint64_t lost = 0;  // messages dropped because this observer is too slow
};
[[nodiscard]] std::string loopText(const LoopFigures& figures, const Sensors& seen);

[[nodiscard]] std::string faultsText(const SafetyReport& safety);
/// `time`: s on the loop's clock, NaN if unknown.
[[nodiscard]] std::string noticeText(std::uint64_t number, double time, const std::string& text);
[[nodiscard]] std::string goneText(const std::string& reason);
[[nodiscard]] std::string cameraText(bool seeing, const std::string& text);
[[nodiscard]] std::string errorText(const std::string& text);

}  // namespace darwinop::monitor
