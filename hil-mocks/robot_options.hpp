// Options of a virtual robot as text: how its servos are set up, and what its board lacks.
#pragma once

#include <string>
#include <string_view>

#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

/// "JOINT=SETTING": a Webots name or an id, then one of servoSettings(). Throws std::runtime_error with what is
/// allowed.
void setServo(BoardOptions& options, std::string_view text);
/// "no-bulk-read", "no-sync-write" or "one-block-length". Throws as setServo().
void setBoard(BoardOptions& options, std::string_view text);

/// The settings of a servo, for error messages and --help.
std::string servoSettings();

}  // namespace darwinop::hil
