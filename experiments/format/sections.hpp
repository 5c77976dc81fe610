// Reads an experiment file into sections and entries; rejects unknown and duplicate names.
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

  /// Null if absent.
  [[nodiscard]] const Entry* find(std::string_view key) const;
};

/// Throws std::runtime_error, "FILE, line N: problem and allowed values".
std::vector<Section> readSections(std::string_view text, const std::string& file);

}  // namespace darwinop::experiments
