// Recordings of a test with columns that are changed or added.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace darwinop::gap {

/// The cells of a CSV without quoted fields, the line of names first.
using Cells = std::vector<std::vector<std::string>>;

inline Cells cellsOf(const std::string& text) {
  Cells out;
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = out.emplace_back();
    std::istringstream fields{line + ","};
    for (std::string field; std::getline(fields, field, ',');) cells.push_back(field);
  }
  return out;
}

inline std::string textOf(const Cells& cells) {
  std::string text;
  for (const std::vector<std::string>& line : cells) {
    for (std::size_t i = 0; i < line.size(); ++i) text += (i == 0 ? "" : ",") + line[i];
    text += "\n";
  }
  return text;
}

inline std::size_t columnIn(const Cells& cells, const std::string& name) {
  const auto found = std::ranges::find_if(
      cells.front(), [&](const std::string& one) { return one == name || one.starts_with(name + " ["); });
  if (found == cells.front().end()) throw std::logic_error("no column " + name);
  return static_cast<std::size_t>(found - cells.front().begin());
}

/// `edit`: from row, from 0, and field.
inline std::string withColumn(const std::string& text, const std::string& name,
                              const std::function<std::string(std::size_t row, const std::string& field)>& edit) {
  Cells cells = cellsOf(text);
  const std::size_t column = columnIn(cells, name);
  for (std::size_t row = 0; row + 1 < cells.size(); ++row) cells[row + 1][column] = edit(row, cells[row + 1][column]);
  return textOf(cells);
}

inline std::string withNegated(const std::string& text, const std::string& name) {
  return withColumn(text, name, [](std::size_t, const std::string& field) {
    return field.empty() ? field : std::to_string(-std::stod(field));
  });
}

inline std::string withExchanged(const std::string& text, const std::string& one, const std::string& other) {
  Cells cells = cellsOf(text);
  const std::size_t a = columnIn(cells, one), b = columnIn(cells, other);
  for (auto line = std::next(cells.begin()); line != cells.end(); ++line) std::swap((*line)[a], (*line)[b]);
  return textOf(cells);
}

inline std::string withNewColumn(const std::string& text, const std::string& name,
                                 const std::function<std::string(std::size_t row)>& field) {
  Cells cells = cellsOf(text);
  cells.front().push_back(name);
  for (std::size_t row = 0; row + 1 < cells.size(); ++row) cells[row + 1].push_back(field(row));
  return textOf(cells);
}

/// Without the rows [from, to).
inline std::string withoutRows(const std::string& text, std::ptrdiff_t from, std::ptrdiff_t to) {
  Cells cells = cellsOf(text);
  cells.erase(cells.begin() + 1 + from, cells.begin() + 1 + to);
  return textOf(cells);
}

}  // namespace darwinop::gap
