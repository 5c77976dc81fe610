// Requests of a page on the transfer channel, one per message:
//   {"start": {"action": "run", "robot": {"address": "192.168.123.1", "user": "darwin"}, "controller": "~/walker"}}
//   {"cancel": true}   {"more": 17}   {"forget": {"address": "192.168.123.1", "user": "darwin"}}
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::window {

struct RobotAddress {
  std::string address{}, user{};
  std::string key{};       // file; empty: ssh's own keys
  std::uint16_t port = 0;  // of ssh; 0: ssh's default
  bool operator==(const RobotAddress&) const = default;
};

enum class TransferAction : std::uint8_t {
  kStatus,
  kInstall,
  kSend,
  kRun,
  kMakeDefault,
  kNoDefault,
  kStop,
  kLogs,
  kRollBack,
  kUninstall,
};

struct TransferStart {
  TransferAction action = TransferAction::kStatus;
  RobotAddress robot{};
  std::string controller{};              // folder on this computer, for kSend, kRun and kMakeDefault
  std::vector<std::string> arguments{};  // of the controller, for kRun
  bool force = false;                    // install an older version; run in any pose
  std::string host_key{};                // fingerprint to accept for an unknown host
};

struct TransferMessage {
  std::optional<TransferStart> start{};
  bool cancel = false;
  std::optional<std::uint64_t> more{};  // requests console lines from this number on
  std::optional<RobotAddress> forget{};
};

/// "run"
[[nodiscard]] std::string_view nameOf(TransferAction action);
[[nodiscard]] bool hasController(TransferAction action);

/// Nullopt: invalid, with the reason in `why`; nothing of it is applied. Returned strings contain no control
/// characters, and no user or host can be taken for an option.
[[nodiscard]] std::optional<TransferMessage> parseTransfer(std::string_view text, std::string& why);

/// Parses a robot, also of the file of remembered robots. Returns an error text or an empty string.
[[nodiscard]] std::string takeRobot(const nlohmann::json& object, RobotAddress& robot);
[[nodiscard]] nlohmann::json jsonOf(const RobotAddress& robot);
/// Parses a path without checking the file system. Returns an error text or an empty string.
[[nodiscard]] std::string takePath(const nlohmann::json& value, std::string_view what, std::string& path);

}  // namespace darwinop::window
