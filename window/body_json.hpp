// The robot's shape for the page, from the files that the twin is made of, so that the two cannot drift apart.
#pragma once

#include <string>

namespace darwinop::window {

/// Links, joints and drawn shapes as JSON, in metres and radians. `links`, parents first: `name`, `parent` (index, -1:
/// the trunk), `pos` and `quat` (w x y z) in the parent, `joint` (`name`, `axis`, `pos`; null: none), `shapes` (`type`,
/// `size`, `pos`, `quat`, `colour`, `glow`, as in MuJoCo). `sensors`: the axes of both sensors in the trunk.
/// `model` as for the twin: a name or a file. Throws std::runtime_error.
std::string bodyJson(const std::string& model);

}  // namespace darwinop::window
