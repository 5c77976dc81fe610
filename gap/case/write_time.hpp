// When in a row its goal was written, where the logs do not say it.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap {

inline constexpr const char* kWriteTimeKey = "written_before_s";

/// Every goal was written `before_s` before its row was read; without it a goal counts as written right after the read
/// of the row before, and the rest of a row looks like a delay. Throws BadInput: logs with times of their own, goals
/// that are written after the read, or rows that come faster.
void setWriteTime(double before_s, Case& into);

}  // namespace darwinop::gap
