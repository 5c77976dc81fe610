// Messages for the user on stderr; each warning once.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::webots_api {

/// Prints "darwinop: MESSAGE".
void logLine(std::string_view sentence);

/// As logLine(), unless the same message was logged before.
void warnOnce(std::string_view sentence);

/// Warns once that `Robot::CALL("NAME")` returns NULL.
void warnNoDevice(std::string_view call, const std::string& name);

/// Forgets what was logged; for tests.
void forgetWarnings();

}  // namespace darwinop::webots_api
