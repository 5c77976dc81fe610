// Selects the pages of a motion manager: from a file, or the built-in ones.
#pragma once

#include <memory>
#include <string>

#include "managers/motion/page_file.hpp"

namespace managers {

using MotionPages = std::shared_ptr<const darwinop::motion::PageFile>;

/// `custom`: a file, binary or text, or "own" for the built-in pages. If empty: motion_4096.bin in `directory` (with a
/// trailing slash), or the built-in pages with a warning if it is missing. A damaged page of a binary file is left
/// empty, with a warning. Null with a warning if the file is invalid.
[[nodiscard]] MotionPages readMotionPages(const std::string& custom, const std::string& directory);

}  // namespace managers
