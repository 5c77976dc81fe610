// Environment variables for a program that is being started, and for nothing after it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace darwinop::window {

class ScopedSettings {
 public:
  /// NAME=VALUE each.
  explicit ScopedSettings(const std::vector<std::string>& settings);
  ~ScopedSettings();
  ScopedSettings(const ScopedSettings&) = delete;
  ScopedSettings& operator=(const ScopedSettings&) = delete;

 private:
  std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

}  // namespace darwinop::window
