// What is seen where nothing can be drawn: colour bars that say why.
#pragma once

#include <string_view>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Eight bars of full colour: white, yellow, cyan, green, magenta, red, blue, black from left to right. `reason` stands
/// in the lower half. `count` moves a mark along the bottom, so that a picture that stands still shows.
Picture testPattern(int width, int height, std::string_view reason, unsigned count = 0);

}  // namespace darwinop::twin
