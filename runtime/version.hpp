// Which version of the runtime this is.
#pragma once

#include <string>

namespace darwinop::runtime {

/// "0.1.0 (a1b2c3d)": release, and the commit it was built from when that is known.
std::string version();

}  // namespace darwinop::runtime
