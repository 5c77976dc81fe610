// Tables of facts: comma-separated, the first line names the columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace darwinop::twin {

/// A table as it was written: cells stay text, so that a figure reaches the body file digit by digit.
class Csv {
 public:
  /// Throws std::runtime_error with file and line.
  explicit Csv(const std::string& path);

  [[nodiscard]] std::size_t rows() const { return cells_.size(); }
  /// Throws std::runtime_error when there is no such column.
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
  /// Throws std::runtime_error when the cell holds no number.
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;

 private:
  std::string path_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace darwinop::twin
