// An experiment's file as sections with entries: every section and key is known, none stands twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace darwinop::experiments {

struct Entry {
  std::string key, value;
  int line = 0;
};

struct Section {
  std::string kind, name;  // "phase" and "left" of [phase left]
  int line = 0;
  std::vector<Entry> entries;

  /// Null: not there.
  [[nodiscard]] const Entry* find(std::string_view key) const;
};

/// Throws std::runtime_error, "FILE, line N: what is wrong and what is allowed".
std::vector<Section> readSections(std::string_view text, const std::string& file);

}  // namespace darwinop::experiments
