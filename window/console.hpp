// What the installer, the robot and its controller have said: the last lines, for every page that looks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace darwinop::window {

enum class LineKind : std::uint8_t { kCommand, kOutput, kSaid, kWarning, kError };

struct ConsoleLine {
  LineKind kind = LineKind::kOutput;
  std::string text;
};

/// "error"
[[nodiscard]] std::string_view nameOf(LineKind kind);

/// Of a line on stderr: installer and robot begin theirs with their names, compilers say what theirs are and indent
/// what belongs to it; the rest is what a controller complains of. `before`: the kind of the line before.
[[nodiscard]] LineKind kindOfComplaint(std::string_view line, LineKind before);

/// Lines are numbered from 0 on, for as long as the program runs.
class Console {
 public:
  static constexpr std::size_t kMostLines = 2000, kMostBytes = std::size_t{512} * 1024;

  void add(LineKind kind, std::string_view text);
  /// Numbers of the oldest one kept, and of the next one to come.
  [[nodiscard]] std::uint64_t begin() const { return end_ - lines_.size(); }
  [[nodiscard]] std::uint64_t end() const { return end_; }
  [[nodiscard]] const ConsoleLine& at(std::uint64_t number) const { return lines_.at(number - begin()); }

 private:
  std::deque<ConsoleLine> lines_;
  std::size_t bytes_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace darwinop::window
