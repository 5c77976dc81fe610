// Classifies and stores output lines.
#include "window/transfer/console.hpp"

#include <array>

namespace darwinop::window {
namespace {

constexpr std::array<std::string_view, 2> kPrograms{"darwinop install: ", "robot: "};
constexpr std::string_view kErrorMark = "error: ";

bool contains(std::string_view line, std::string_view part) {
  return line.find(part) != std::string_view::npos;
}

}  // namespace

std::string_view nameOf(LineKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"command", "output", "said", "warning", "error"};
  return kNames.at(static_cast<std::size_t>(kind));
}

LineKind classifyStderrLine(std::string_view line, LineKind before) {
  for (const std::string_view program : kPrograms)
    if (line.starts_with(program))
      return line.substr(program.size()).starts_with(kErrorMark) ? LineKind::kError : LineKind::kMessage;
  if (contains(line, ": warning: ")) return LineKind::kWarning;
  if (contains(line, ": error: ") || contains(line, ": fatal error: ")) return LineKind::kError;
  if (contains(line, ": note: ")) return LineKind::kMessage;
  if (line.starts_with("In file included from ") || contains(line, ": In function ") ||
      contains(line, ": At global scope:"))
    return LineKind::kMessage;
  return line.starts_with(' ') ? before : LineKind::kError;
}

void Console::add(LineKind kind, std::string_view text) {
  lines_.push_back({kind, std::string{text}});
  bytes_ += text.size();
  ++end_;
  while (lines_.size() > kMostLines || bytes_ > kMostBytes) {
    bytes_ -= lines_.front().text.size();
    lines_.pop_front();
  }
}

}  // namespace darwinop::window
