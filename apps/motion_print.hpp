// Text output of `darwinop motion`: a line per page, or one page in full.
#pragma once

#include <string>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Page name with control characters removed, for terminals.
[[nodiscard]] std::string nameOf(const Page& page);
/// Table of the playable pages.
[[nodiscard]] std::string listOf(const PageFile& pages);
/// Times, angles and gains by step.
[[nodiscard]] std::string pictureOf(const PageFile& pages, int page);

}  // namespace darwinop::motion
