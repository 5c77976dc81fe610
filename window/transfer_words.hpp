// What a page may say on the transfer channel, one of it a message:
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
  std::uint16_t port = 0;  // of ssh; 0: as ssh has it
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
  std::string controller{};              // folder on this computer, of kSend, kRun and kMakeDefault
  std::vector<std::string> arguments{};  // of the controller, for kRun
  bool force = false;                    // install an older version; run whatever the pose is
  std::string host_key{};                // fingerprint that an unknown robot may have
};

struct TransferWords {
  std::optional<TransferStart> start{};
  bool cancel = false;
  std::optional<std::uint64_t> more{};  // lines of the console from this number on
  std::optional<RobotAddress> forget{};
};

/// "run"
[[nodiscard]] std::string_view nameOf(TransferAction action);
[[nodiscard]] bool hasController(TransferAction action);

/// Nothing, and `why`: it was not understood, and nothing of it counts. No word of what is returned holds a character
/// that ends lines or words, and no user or host can be taken for an option.
[[nodiscard]] std::optional<TransferWords> readTransfer(std::string_view text, std::string& why);

/// The object of a robot, also of the file of remembered ones. Empty: `robot` has it.
[[nodiscard]] std::string takeRobot(const nlohmann::json& said, RobotAddress& robot);
[[nodiscard]] nlohmann::json jsonOf(const RobotAddress& robot);
/// A path, not looked at yet. Empty: it could be one.
[[nodiscard]] std::string takePath(const nlohmann::json& said, std::string_view what, std::string& path);

}  // namespace darwinop::window
