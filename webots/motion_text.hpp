// Parser of .motion files: poses over time, as one curve per joint. Format: docs/motions.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::webots_api {

struct MotionKey {
  int ms;
  double rad;
};

/// One column of the file; keys sorted by time.
struct MotionCurve {
  std::string motor;
  std::vector<MotionKey> keys;

  /// Linear between two keys, constant after the last one; empty before the first.
  [[nodiscard]] std::optional<double> at(double ms) const;
  /// As at(); before the first key its value. Empty without keys.
  [[nodiscard]] std::optional<double> atOrFirst(double ms) const;
};

struct MotionText {
  std::vector<MotionCurve> curves;
  int duration_ms = 0;  // time of the last pose
};

/// Throws std::runtime_error, "FILE:LINE: field N: reason", if the text is invalid.
[[nodiscard]] MotionText parseMotion(std::string_view text, const std::string& file);

/// As parseMotion().
[[nodiscard]] MotionText readMotion(const std::string& file);

}  // namespace darwinop::webots_api
