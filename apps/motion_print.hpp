// How `darwinop motion` shows pages: a line each, or all of one.
#pragma once

#include <string>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// A name from a file may hold anything; a terminal shall not obey it.
[[nodiscard]] std::string nameOf(const Page& page);
/// A table of the pages that can be played.
[[nodiscard]] std::string listOf(const PageFile& pages);
/// Times and angles by step, and gains, as a person reads them.
[[nodiscard]] std::string pictureOf(const PageFile& pages, int page);

}  // namespace darwinop::motion
