// Parses a log line by line.
#include "experiments/logs/read_log.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "experiments/logs/header.hpp"
#include "hal/text_file.hpp"

namespace darwinop::logs {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kFormat = "darwinop log, format ";

class Parser {
 public:
  explicit Parser(const std::string& file) { log_.file = file; }

  Log parse(std::string_view text) {
    try {
      rest_ = withoutBom(text);
      while (!rest_.empty()) next();
      if (log_.columns.empty())
        throw std::runtime_error("no header line with column names; check that this is a log of darwinop");
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(log_.file + ", line " + std::to_string(std::max(line_, 1u)) + ": " + error.what());
    }
    checkEnd();
    return std::move(log_);
  }

 private:
  static std::string_view withoutBom(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
      throw std::runtime_error("the text is UTF-16; save the file as UTF-8");
    return text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  }

  void next() {
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    const bool terminated = end != std::string_view::npos;
    rest_.remove_prefix(terminated ? end + 1 : rest_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_;
    if (line.empty()) return;
    if (line.front() == '#') return comment(line.substr(1));
    if (log_.columns.empty()) return header(line);
    if (ended_) throw std::runtime_error("rows after \"# end\"; if the file contains two recordings, split it");
    if (!terminated && isTruncated(line)) return skipTruncated();
    row(line);
  }

  void comment(std::string_view text) {
    if (text.starts_with(' ')) text.remove_prefix(1);
    if (text == "end") ended_ = true;
    if (text.starts_with("lost rows: ")) {
      const std::string_view number = text.substr(11);
      (void)std::from_chars(number.data(), number.data() + number.size(), log_.lost_rows);
    }
    if (!log_.columns.empty()) return;
    if (text.starts_with(kFormat)) {
      log_.recording = true;
      if (text.substr(kFormat.size()) != "1")
        throw std::runtime_error("this log has format " + quotedField(text.substr(kFormat.size())) +
                                 ", this program reads format 1; use a newer version");
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return;
    std::string_view value = text.substr(colon + 1);
    if (value.starts_with(' ')) value.remove_prefix(1);
    log_.head.push_back({std::string{text.substr(0, colon)}, std::string{value}});
  }

  void header(std::string_view line) {
    readHeader(line, log_);
    header_line_ = line_;
  }

  /// A last line without a line end. Recordings always terminate lines, so the last number may lack digits; in other
  /// files only a missing field shows a truncation.
  [[nodiscard]] bool isTruncated(std::string_view line) const {
    return log_.recording || std::size_t(std::count(line.begin(), line.end(), ',')) + 1 < log_.columns.size();
  }

  void skipTruncated() {
    log_.warnings.push_back(log_.file + ", line " + std::to_string(line_) +
                            ": the file ends in the middle of this row; the row is skipped");
  }

  void row(std::string_view line) {
    std::size_t column = 0;
    values_.resize(log_.columns.size());
    forEachField(line, [&](std::string_view field) {
      if (column < values_.size()) values_[column] = number(field, column);
      ++column;
    });
    if (column != values_.size())
      throw std::runtime_error(std::to_string(column) + " fields, but line " + std::to_string(header_line_) +
                               " names " + std::to_string(values_.size()) + " columns");
    checkTime();
    if (log_.rows() == 0) reserve(line.size());
    for (std::size_t i = 0; i < values_.size(); ++i) log_.columns[i].values.push_back(values_[i]);
    log_.lines.push_back(line_);
  }

  [[nodiscard]] double number(std::string_view field, std::size_t column) const {
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    if (field.empty()) return kUnknown;
    if (field.starts_with('+')) field.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error == std::errc{} && end == field.data() + field.size()) return value;
    throw std::runtime_error(quotedField(field) + " in column " + quotedField(log_.columns[column].name) +
                             " is not a number; leave the field empty if the value is unknown");
  }

  void checkTime() const {
    const double now = values_[log_.time];
    const std::string name = quotedField(log_.columns[log_.time].name);
    if (!std::isfinite(now)) throw std::runtime_error("column " + name + " is empty; every row needs a time");
    if (log_.rows() == 0 || now > log_.columns[log_.time].values.back()) return;
    throw std::runtime_error(std::string{kTimeGoesBack} + ": column " + name + " has " + std::to_string(now) +
                             " after " + std::to_string(log_.columns[log_.time].values.back()) +
                             "; if the file contains two logs, split it");
  }

  void reserve(std::size_t length) {
    const std::size_t rows = rest_.size() / (length + 1) + 2;
    for (Column& column : log_.columns) column.values.reserve(rows);
    log_.lines.reserve(rows);
  }

  void checkEnd() {
    log_.complete = ended_ || !log_.recording;
    if (!log_.complete)
      log_.warnings.push_back(log_.file + kNoEnd +
                              ": the recording program was killed or is still running; up to 0.1 s may be missing");
    if (log_.lost_rows != 0)
      log_.warnings.push_back(log_.file + ": " + std::to_string(log_.lost_rows) +
                              " rows were lost while recording because the disk was too slow");
  }

  Log log_;
  std::string_view rest_;
  std::vector<double> values_;  // of the row that is being read
  std::uint32_t line_ = 0, header_line_ = 0;
  bool ended_ = false;
};

}  // namespace

Log parseLog(std::string_view text, const std::string& file) {
  return Parser{file}.parse(text);
}

Log readLog(const std::string& path) {
  const auto text = readTextFile(path, kLongestLog);
  if (!text) throw std::runtime_error("cannot read " + path + ": " + std::strerror(ENOENT));
  return parseLog(*text, path);
}

}  // namespace darwinop::logs
