// Test pattern for a camera without OpenGL: colour bars with the reason.
#pragma once

#include <string_view>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Eight bars from left to right: white, yellow, cyan, green, magenta, red, blue, black. `reason` is drawn in the lower
/// half. `count` moves a mark along the bottom edge, so that a frozen picture is visible.
RenderedPicture testPattern(int width, int height, std::string_view reason, unsigned count = 0);

}  // namespace darwinop::twin
