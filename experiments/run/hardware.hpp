// Would a run move metal? Then a person has to agree first.
#pragma once

#include <string>

namespace darwinop::experiments {

/// `setting` as DARWINOP_ROBOT. True for the daemon and for every serial device that is not, provably, the pty of a
/// `darwinop virtual-robot` on this computer. Throws std::runtime_error when the setting names no robot.
bool mayBeHardware(const std::string& setting);

}  // namespace darwinop::experiments
