// Data that belong to others and are not part of this project: example cases, logs of real servos, vendor files.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace darwinop {

/// `name` in the folder that the environment variable DARWINOP_SHARED names; without one, a path that does not exist.
/// Tests that need it skip then, and say so.
inline std::filesystem::path sharedData(const std::string& name) {
  const char* const folder = std::getenv("DARWINOP_SHARED");
  return std::filesystem::path{folder != nullptr ? folder : "$DARWINOP_SHARED"} / name;
}

}  // namespace darwinop
