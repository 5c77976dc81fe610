// Bytes as they come from a program, cut into lines.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace darwinop::window {

/// A line that is too long is shown to kLongest, with "…" in the place of the rest.
class LineCutter {
 public:
  static constexpr std::size_t kLongest = 2000;
  using Take = std::function<void(std::string_view line)>;

  void add(std::string_view bytes, const Take& take);
  /// Nothing more comes: what has no end yet is a line, too.
  void end(const Take& take);

 private:
  void finish(const Take& take);

  std::string line_;
  bool cut_ = false;
};

}  // namespace darwinop::window
