// One line of a check-up: how bad it is, what was found, and what mends it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace darwinop::cm730 {

enum class Level : std::uint8_t {
  kOk,
  kWarning,  // the robot can be driven; something is worth mending
  kError,    // the robot, or a part of it, cannot be driven
};

struct Finding {
  Level level = Level::kOk;
  std::string what;
  std::string mend;  // a sentence or a command; empty when there is nothing to mend
};
using Findings = std::vector<Finding>;

inline Level worst(std::span<const Finding> findings) {
  Level level = Level::kOk;
  for (const Finding& finding : findings) level = std::max(level, finding.level);
  return level;
}

/// "warn  what" and, when there is something to mend, a line "      -> mend".
inline std::string toText(const Finding& finding) {
  static constexpr const char* kMarks[] = {"ok    ", "warn  ", "FAIL  "};
  std::string text = kMarks[static_cast<std::size_t>(finding.level)] + finding.what + "\n";
  if (!finding.mend.empty()) text += "      -> " + finding.mend + "\n";
  return text;
}

}  // namespace darwinop::cm730
