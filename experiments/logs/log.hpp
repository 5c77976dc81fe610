// A log in memory: header and columns of numbers over time. Read by experiments/logs/read_log.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::logs {

/// "# robot: Darwin 7"
struct HeadLine {
  std::string key, value;
};

struct Column {
  std::string name;            // without brackets: "Neck.position", "pos_rad"
  std::string unit;            // as in the file: "rad", "%", ""; values are not converted
  std::vector<double> values;  // one per row; NaN: unknown
};

struct Log {
  std::string file;  // path as given, for messages
  std::vector<HeadLine> head;
  std::vector<Column> columns;
  std::vector<std::uint32_t> lines;   // line number of each row, from 1
  std::size_t time = 0;               // index of the time column; finite, strictly increasing
  double second = 1;                  // unit of the time column, s
  std::uint64_t lost_rows = 0;        // not written by the recorder
  bool recording = false;             // written by the runtime; ends with "# end" unless it was killed
  bool complete = true;               // false: a recording without "# end"
  std::vector<std::string> warnings;  // problems that leave the rest usable

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] double seconds(std::size_t row) const { return columns[time].values[row] * second; }

  /// Empty or null if absent.
  [[nodiscard]] std::optional<std::string> headValue(std::string_view key) const;
  [[nodiscard]] const Column* find(std::string_view name) const;
  /// Throws std::runtime_error with the available columns.
  [[nodiscard]] const Column& column(std::string_view name) const;
};

}  // namespace darwinop::logs
