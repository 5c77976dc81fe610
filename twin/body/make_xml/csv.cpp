// Reads the CSV tables of the body.
#include "twin/body/make_xml/csv.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace darwinop::twin {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

}  // namespace

Csv::Csv(const std::string& path) : path_{path} {
  std::ifstream file{path};
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error{path + ": " + kNoHeaderLine};
  columns_ = split(line);
  while (std::getline(file, line)) {
    cells_.push_back(split(line));
    if (cells_.back().size() != columns_.size())
      throw std::runtime_error{path + ", line " + std::to_string(cells_.size() + 1) + ": " +
                               std::to_string(cells_.back().size()) + " cells; the header has " +
                               std::to_string(columns_.size())};
  }
}

const std::string& Csv::text(std::size_t row, std::string_view column) const {
  const auto found = std::ranges::find(columns_, column);
  if (found == columns_.end()) throw std::runtime_error{path_ + ": no column \"" + std::string{column} + '"'};
  return cells_.at(row).at(static_cast<std::size_t>(found - columns_.begin()));
}

double Csv::number(std::size_t row, std::string_view column) const {
  const std::string& cell = text(row, column);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size())
    throw std::runtime_error{path_ + ", line " + std::to_string(row + 2) + ", " + std::string{column} + ": \"" + cell +
                             "\" is not a number"};
  return value;
}

}  // namespace darwinop::twin
