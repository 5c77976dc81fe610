// Preview of `darwinop motion play`.
#pragma once

#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"
#include "webots/motion_text.hpp"

namespace darwinop::motion {

/// One line per page: name, duration, distance to its first pose, lead-in. The robot starts in its start pose. `pages`
/// must be playable.
[[nodiscard]] std::string previewOf(const PageFile& file, const std::vector<int>& pages);
[[nodiscard]] std::string previewOf(const webots_api::MotionText& motion, const std::string& file);

}  // namespace darwinop::motion
