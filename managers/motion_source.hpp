// Which pages a motion manager plays: those of a file, or the runtime's own.
#pragma once

#include <memory>
#include <string>

#include "managers/motion/page_file.hpp"

namespace managers {

using MotionPages = std::shared_ptr<const darwinop::motion::PageFile>;

/// `custom`: a file, binary or text, or "own"; "": motion_4096.bin in `directory`, which ends with a slash, and the own
/// pages where there is none, which is said. What is there but broken is never replaced: none, and why was said.
[[nodiscard]] MotionPages readMotionPages(const std::string& custom, const std::string& directory);

}  // namespace managers
