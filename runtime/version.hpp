// Version of the runtime.
#pragma once

#include <string>

namespace darwinop::runtime {

/// Release and, if known, commit: "0.1.0 (a1b2c3d)".
std::string version();

}  // namespace darwinop::runtime
