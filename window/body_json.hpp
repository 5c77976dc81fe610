// The robot's shape for the page, from the files that the twin is made of, so that the two cannot drift apart.
#pragma once

#include <string>

namespace darwinop::window {

/// Links, joints and the shapes that are drawn, in metres and radians, as JSON; docs/window.md shows the format.
/// `model` as for the twin: a name or a file. Throws std::runtime_error.
std::string bodyJson(const std::string& model);

}  // namespace darwinop::window
