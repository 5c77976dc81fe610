// Parser of darwinop-install's progress lines.
#include "window/transfer/installer_step.hpp"

#include <algorithm>
#include <charconv>

namespace darwinop::window {
namespace {

/// Removes and returns the text up to the next space.
std::string_view wordOf(std::string_view& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return word;
}

template <class Number>
bool readWhole(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc{} && end == word.data() + word.size();
}

bool isOfBase64(char letter) {
  return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
         letter == '+' || letter == '/';
}

}  // namespace

std::optional<InstallerStep> readStep(std::string_view line) {
  if (wordOf(line) != "progress") return std::nullopt;
  InstallerStep step;
  if (!readWhole(wordOf(line), step.number) || !readWhole(wordOf(line), step.of)) return std::nullopt;
  if (step.number < 1 || step.number > step.of) return std::nullopt;
  if (const std::string_view part = wordOf(line); part != "-") {
    double done = 0;
    if (!readWhole(part, done) || !(done >= 0 && done <= 1)) return std::nullopt;
    step.part = done;
  }
  step.name = line;
  return step;
}

std::string_view readHostKey(std::string_view line) {
  if (wordOf(line) != "host-key" || !isFingerprint(line)) return {};
  return line;
}

bool isFingerprint(std::string_view text) {
  constexpr std::string_view kKind = "SHA256:";
  return text.size() == kKind.size() + 43 && text.starts_with(kKind) &&
         std::ranges::all_of(text.substr(kKind.size()), isOfBase64);
}

}  // namespace darwinop::window
