// A servo's row while it is written: its problems become one finding.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::cm730 {

class ServoRow {
 public:
  ServoRow(Joint joint, std::string what) : row_{Finding::ok(std::move(what))} { row_.joint = joint; }
  void add(Kind kind, std::string_view problem, std::string_view remedy) {
    row_.level = std::max(row_.level, levelOf(kind));
    row_.kinds.set(static_cast<std::size_t>(kind));
    append("; ", problem);
    if (!row_.remedy.empty()) row_.remedy += "; ";
    row_.remedy += remedy;
  }
  /// Adds a note without a problem.
  void note(std::string_view text) { append("; ", text); }
  [[nodiscard]] Finding take() { return std::move(row_); }

 private:
  void append(std::string_view separator, std::string_view text) {
    if (!text.empty()) row_.what.append(separator).append(text);
  }
  Finding row_;
};

}  // namespace darwinop::cm730
