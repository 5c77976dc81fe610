// Sets environment variables for the start of a child process and restores them afterwards.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace darwinop::window {

class ScopedEnvironment {
 public:
  /// Entries of the form NAME=VALUE.
  explicit ScopedEnvironment(const std::vector<std::string>& settings);
  ~ScopedEnvironment();
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

}  // namespace darwinop::window
