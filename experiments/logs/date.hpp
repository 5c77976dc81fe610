// When a recording was made.
#pragma once

#include <optional>

#include "experiments/logs/log.hpp"

namespace darwinop::logs {

/// "date" in the head: when it began, s since 1970 by the computer's clock, to 1 s. Nothing: not there, or not UTC.
std::optional<double> dateOf(const Log& recording);

}  // namespace darwinop::logs
