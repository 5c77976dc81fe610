// The text of a .motion file: poses at times, as curves of joints. Source: docs/motions.md.
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

/// One column of the file; keys in the order of time.
struct MotionCurve {
  std::string motor;
  std::vector<MotionKey> keys;

  /// Linear between two keys, held behind the last one; none before the first.
  [[nodiscard]] std::optional<double> at(double ms) const;
};

struct MotionText {
  std::vector<MotionCurve> curves;
  int duration_ms = 0;  // time of the last pose
};

/// Throws std::runtime_error, "FILE:LINE: field N: why", when anything is wrong with it.
[[nodiscard]] MotionText parseMotion(std::string_view text, const std::string& file);

/// As parseMotion().
[[nodiscard]] MotionText readMotion(const std::string& file);

}  // namespace darwinop::webots_api
