// Messages about a serial port, for programs that do not write to it themselves.
#pragma once

#include <string>

namespace darwinop::cm730 {

/// After howToStopRuntime(), where the port is in use.
inline constexpr const char* kDriveThroughRuntime = "; a controller can drive through it: --robot runtime";

/// "stop it with ...": a runtime daemon of that process id.
std::string howToStopRuntime(const std::string& pid);

/// Throws std::runtime_error with a remedy if the port cannot be opened. Nothing is sent.
void requirePort(const std::string& path);

}  // namespace darwinop::cm730
