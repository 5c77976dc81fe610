// Reads a recording of the runtime back: rows of numbers by column name, empty fields as NaN.
#pragma once

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace darwinop {

class Recording {
 public:
  explicit Recording(const std::string& path) {
    std::ifstream file{path};
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      if (columns_.empty())
        readHead(line);
      else
        rows_.push_back(readRow(line));
    }
    if (columns_.empty()) throw std::runtime_error("no recording in " + path);
  }

  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] double at(std::size_t row, const std::string& column) const {
    return rows_[row].at(columns_.at(column));
  }

 private:
  void readHead(const std::string& line) {
    std::istringstream fields{line};
    for (std::string name; std::getline(fields, name, ',');) columns_.emplace(name, columns_.size());
  }
  static std::vector<double> readRow(const std::string& line) {
    std::vector<double> row;
    std::istringstream fields{line};
    for (std::string field; std::getline(fields, field, ',');)
      row.push_back(field.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(field.c_str(), nullptr));
    row.resize(1000, std::numeric_limits<double>::quiet_NaN());
    return row;
  }

  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace darwinop
