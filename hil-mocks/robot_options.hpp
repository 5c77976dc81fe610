// Command line options of a virtual robot: servo settings and missing board features.
#pragma once

#include <string>
#include <string_view>

#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

/// "JOINT=SETTING": a Webots name or an id, then one of servoSettings(). Throws std::runtime_error with the allowed
/// values.
void setServo(BoardOptions& options, std::string_view text);
/// "cm-730", "cm-740", "none", "no-bulk-read", "no-sync-write", "one-block-length" or "model:NUMBER". Throws like
/// setServo().
void setBoard(BoardOptions& options, std::string_view text);

/// Servo settings, for error messages and --help.
std::string servoSettings();

}  // namespace darwinop::hil
