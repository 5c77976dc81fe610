// Messages to the user: sentences on stderr, each warning once.
#pragma once

#include <string_view>

namespace darwinop::webots_api {

/// Prints "darwinop: SENTENCE".
void logLine(std::string_view sentence);

/// As logLine(), unless the same sentence was logged before.
void warnOnce(std::string_view sentence);

/// Forgets what was logged; for tests.
void forgetWarnings();

}  // namespace darwinop::webots_api
