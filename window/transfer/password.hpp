// A password from the page for the program that logs in: one buffer in memory, wiped after use.
#pragma once

#include <string.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace darwinop::window {

class Password {
 public:
  static constexpr std::size_t kLongest = 200;

  Password() = default;
  ~Password() { wipe(); }
  Password(const Password&) = delete;
  Password& operator=(const Password&) = delete;

  /// False: too long, or contains NUL or line ends; no password is stored then.
  bool set(std::string_view text) {
    wipe();
    if (text.size() > kLongest || text.find_first_of(std::string_view{"\0\n\r", 3}) != std::string_view::npos)
      return false;
    std::ranges::copy(kName, variable_.begin());
    std::ranges::copy(text, variable_.begin() + kName.size());
    return true;
  }
  void wipe() noexcept { explicit_bzero(variable_.data(), variable_.size()); }

  /// Environment entry "DARWINOP_PASSWORD=…"; null: no password.
  [[nodiscard]] char* variable() {
    return variable_[0] == '\0' || variable_[kName.size()] == '\0' ? nullptr : &variable_[0];
  }

 private:
  static constexpr std::string_view kName = "DARWINOP_PASSWORD=";
  std::array<char, kName.size() + kLongest + 1> variable_{};
};

}  // namespace darwinop::window
