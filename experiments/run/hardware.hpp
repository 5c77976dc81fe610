// Detects whether a robot setting may refer to hardware; the user must confirm runs on hardware.
#pragma once

#include <string>

namespace darwinop::experiments {

/// `setting` as DARWINOP_ROBOT. True for the daemon and for every serial device that is not provably the pty of a
/// `darwinop virtual-robot` on this computer. Throws std::runtime_error for an invalid setting.
bool mayBeHardware(const std::string& setting);

}  // namespace darwinop::experiments
