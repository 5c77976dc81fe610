// What `darwinop motion play` will do, said before it does it.
#pragma once

#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"
#include "webots/motion_text.hpp"

namespace darwinop::motion {

/// A line for each page: name, seconds, how far its first pose is, and how the joints get there. The robot begins in
/// its start pose. `pages` can be played.
[[nodiscard]] std::string previewOf(const PageFile& file, const std::vector<int>& pages);
[[nodiscard]] std::string previewOf(const facade::MotionText& motion, const std::string& file);

}  // namespace darwinop::motion
