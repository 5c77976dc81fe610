// What a file says.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

namespace darwinop {

/// All of it; empty when there is no such file.
inline std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path}.rdbuf();
  return text.str();
}

}  // namespace darwinop
