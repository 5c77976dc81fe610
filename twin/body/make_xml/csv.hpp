// CSV tables with a header line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace darwinop::twin {

inline constexpr const char* kNoHeaderLine = "cannot read the file, or it is empty";

/// Cells are kept as text, so that numbers are copied to the body file unchanged.
class Csv {
 public:
  /// Throws std::runtime_error with file and line.
  explicit Csv(const std::string& path);

  [[nodiscard]] std::size_t rows() const { return cells_.size(); }
  /// Throws std::runtime_error if there is no such column.
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
  /// Throws std::runtime_error if the cell is not a number.
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;

 private:
  std::string path_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace darwinop::twin
