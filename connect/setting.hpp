// Parses DARWINOP_ROBOT and --robot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace darwinop::connect {

enum class RobotKind { kDaemon, kSerial, kVirtual, kTwin, kTcp };

/// Address of a remote robot.
struct Address {
  std::string host;  // name or IPv4 address
  std::uint16_t port = 5023;
};

struct Setting {
  RobotKind kind;
  std::string port;   // kSerial: the device
  std::string model;  // kTwin: name or file of the model; empty: the default one
  Address server{};   // kTcp
};

/// Parses a setting. Empty: the daemon if one runs, else the serial port of robot.ini. Throws std::runtime_error with
/// the choices if it is invalid.
Setting readSetting(const std::string& text);

/// The loop runs in another process, with its own settings and recordings.
constexpr bool loopIsElsewhere(const Setting& setting) {
  return setting.kind == RobotKind::kDaemon || setting.kind == RobotKind::kTcp;
}

/// Model of "twin" (empty: the default one) or "twin:MODEL"; nothing for other settings.
std::optional<std::string> twinModel(const std::string& text);

/// Valid settings, one line each, for error messages and --help.
std::string settingChoices();

}  // namespace darwinop::connect
