// Which robot is meant by DARWINOP_ROBOT or --robot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace darwinop::connect {

enum class Kind { kDaemon, kSerial, kVirtual, kTwin, kTcp };

/// Where a robot listens.
struct Address {
  std::string host;  // name or IPv4 address
  std::uint16_t port = 5023;
};

struct Setting {
  Kind kind;
  std::string port;   // kSerial: the device
  std::string model;  // kTwin: name or file of the model; empty: the usual one
  Address server{};   // kTcp
};

/// Reads a setting; an empty one means the daemon if one runs, else the serial port of robot.ini. Throws
/// std::runtime_error, with the choices, for anything that is not a robot.
Setting readSetting(const std::string& text);

/// The loop does not run in the controller's process: it has settings of its own, and makes recordings by itself.
constexpr bool loopIsElsewhere(const Setting& setting) {
  return setting.kind == Kind::kDaemon || setting.kind == Kind::kTcp;
}

/// The model in "twin" (empty: the usual one) or "twin:MODEL"; nothing: no twin is meant.
std::optional<std::string> twinModel(const std::string& text);

/// The choices, one line each, for error messages and --help.
std::string settingChoices();

}  // namespace darwinop::connect
