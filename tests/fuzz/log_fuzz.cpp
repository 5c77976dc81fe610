// Recording: an error message, or a log whose invariants hold.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "experiments/logs/read_log.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSane(const darwinop::logs::Log& log) {
  require(!log.columns.empty() && log.time < log.columns.size());
  for (const auto& column : log.columns) {
    require(!column.name.empty() && column.values.size() == log.rows());
    require(log.find(column.name) == &column);
  }
  for (std::size_t row = 0; row < log.rows(); ++row) {
    require(std::isfinite(log.seconds(row)));
    require(row == 0 || (log.seconds(row) >= log.seconds(row - 1) && log.lines[row] > log.lines[row - 1]));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    requireSane(darwinop::logs::parseLog({reinterpret_cast<const char*>(data), size}, "log.csv"));
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with("log.csv, line "));
  }
  return 0;
}
