// Geometry of the robot for the page, from the twin's model files.
#pragma once

#include <string>

namespace darwinop::window {

/// Links, joints and visual shapes as JSON, in metres and radians. `links`, parents first: `name`, `parent` (index, -1:
/// the trunk), `pos` and `quat` (w x y z) in the parent, `joint` (`name`, `axis`, `pos`; null: none), `shapes` (`type`,
/// `size`, `pos`, `quat`, `colour`, `glow`, as in MuJoCo). `sensors`: the axes of both sensors in the trunk.
/// `model` as for the twin: a name or a file. Throws std::runtime_error.
std::string bodyJson(const std::string& model);

}  // namespace darwinop::window
