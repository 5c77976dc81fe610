#include "window/console.hpp"

#include <array>

namespace darwinop::window {
namespace {

constexpr std::array<std::string_view, 2> kSpeakers{"darwinop install: ", "robot: "};
constexpr std::string_view kErrorMark = "error: ";

bool holds(std::string_view line, std::string_view part) {
  return line.find(part) != std::string_view::npos;
}

}  // namespace

std::string_view nameOf(LineKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"command", "output", "said", "warning", "error"};
  return kNames.at(static_cast<std::size_t>(kind));
}

LineKind kindOfComplaint(std::string_view line, LineKind before) {
  for (const std::string_view speaker : kSpeakers)
    if (line.starts_with(speaker))
      return line.substr(speaker.size()).starts_with(kErrorMark) ? LineKind::kError : LineKind::kSaid;
  if (holds(line, ": warning: ")) return LineKind::kWarning;
  if (holds(line, ": error: ") || holds(line, ": fatal error: ")) return LineKind::kError;
  if (holds(line, ": note: ")) return LineKind::kSaid;
  if (line.starts_with("In file included from ") || holds(line, ": In function ") || holds(line, ": At global scope:"))
    return LineKind::kSaid;
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
