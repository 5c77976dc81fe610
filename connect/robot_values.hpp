// Values of robot.ini from their text. What is not allowed throws std::runtime_error with section, key and what is.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "core/servo_models.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::connect {

[[noreturn]] void refuse(std::string_view section, std::string_view key, std::string_view value,
                         const std::string& allowed);

/// Path of a device.
std::string device(std::string_view key, std::string_view value, const char* example);
/// Name of a user or group, or nothing; `what` for the message.
std::string accountName(std::string_view key, std::string_view value, const char* what);
Nanos periodInMs(std::string_view key, std::string_view value);
/// 0 to 65535.
std::uint16_t modelNumber(std::string_view key, std::string_view value);
/// True for "none": servos alone on an adapter.
bool permitsNoBoard(std::string_view key, std::string_view value);
/// "Neck, Head"; nothing: none.
std::bitset<kJoints> jointNames(std::string_view key, std::string_view value);
/// "MX-64, MX-106"; nothing: none.
ServoModels servoModels(std::string_view key, std::string_view value);
/// The items of "A, B" without blanks; an empty one where one is missing. Nothing: none.
std::vector<std::string_view> listed(std::string_view value);

}  // namespace darwinop::connect
