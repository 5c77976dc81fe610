// Console of the transfer tab: last output lines of installer, robot and controller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace darwinop::window {

enum class LineKind : std::uint8_t { kCommand, kOutput, kMessage, kWarning, kError };

struct ConsoleLine {
  LineKind kind = LineKind::kOutput;
  std::string text;
};

/// "error"
[[nodiscard]] std::string_view nameOf(LineKind kind);

/// Classifies a line of stderr: lines of installer and robot start with their name, compiler lines contain their
/// severity, indented lines continue the previous one; all others are errors of a controller. `before`: kind of the
/// previous line.
[[nodiscard]] LineKind classifyStderrLine(std::string_view line, LineKind before);

/// Lines are numbered from 0 for the lifetime of the program.
class Console {
 public:
  static constexpr std::size_t kMostLines = 2000, kMostBytes = std::size_t{512} * 1024;

  void add(LineKind kind, std::string_view text);
  /// Number of the oldest line kept, and one past the newest.
  [[nodiscard]] std::uint64_t begin() const { return end_ - lines_.size(); }
  [[nodiscard]] std::uint64_t end() const { return end_; }
  [[nodiscard]] const ConsoleLine& at(std::uint64_t number) const { return lines_.at(number - begin()); }

 private:
  std::deque<ConsoleLine> lines_;
  std::size_t bytes_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace darwinop::window
