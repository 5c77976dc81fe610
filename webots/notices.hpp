// What the facade tells the user: plain sentences on stderr, each warning once.
#pragma once

#include <string_view>

namespace darwinop::facade {

/// Prints "darwinop: SENTENCE".
void say(std::string_view sentence);

/// As say(), unless this very sentence was said before.
void warnOnce(std::string_view sentence);

/// Forgets what was said; for tests.
void forgetWarnings();

}  // namespace darwinop::facade
