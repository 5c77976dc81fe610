// Text of a finding.
#pragma once

#include <cstdio>
#include <string>

namespace darwinop::cm730 {

/// As printf; at most 199 characters.
template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

}  // namespace darwinop::cm730
