// The text of quick.txt, embedded by CMake.
#pragma once

#include <string_view>

namespace darwinop::gap::quick {

extern const std::string_view kSuite;

}  // namespace darwinop::gap::quick
