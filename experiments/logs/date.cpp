#include "experiments/logs/date.hpp"

#include <ctime>

namespace darwinop::logs {

std::optional<double> dateOf(const Log& recording) {
  std::tm begin{};
  const std::string date = recording.headValue("date").value_or("");
  if (strptime(date.c_str(), "%Y-%m-%dT%H:%M:%SZ", &begin) == nullptr) return std::nullopt;
  return static_cast<double>(timegm(&begin));
}

}  // namespace darwinop::logs
