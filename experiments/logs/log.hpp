// A log in memory: columns of numbers over time, with what its head tells. Made by experiments/logs/read_log.hpp.
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
  std::string unit;            // as the log has it: "rad", "%", ""; values are not converted
  std::vector<double> values;  // one a row; NaN: not known
};

struct Log {
  std::string file;  // as it was asked for; errors and warnings begin with it
  std::vector<HeadLine> head;
  std::vector<Column> columns;
  std::vector<std::uint32_t> lines;   // where in the file each row stands, from 1
  std::size_t time = 0;               // index of the column of time; its values are known and rise
  double second = 1;                  // length in seconds of the time column's unit
  std::uint64_t lost_rows = 0;        // the recorder could not write them
  bool recording = false;             // written by the runtime: ends with "# end" when it was not killed
  bool complete = true;               // false: a recording without "# end"
  std::vector<std::string> warnings;  // sentences: what is odd, though the rest can be used

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] double seconds(std::size_t row) const { return columns[time].values[row] * second; }

  /// Nothing, or null: the log does not have it.
  [[nodiscard]] std::optional<std::string> headValue(std::string_view key) const;
  [[nodiscard]] const Column* find(std::string_view name) const;
  /// Throws std::runtime_error that names the columns there are.
  [[nodiscard]] const Column& column(std::string_view name) const;
};

}  // namespace darwinop::logs
