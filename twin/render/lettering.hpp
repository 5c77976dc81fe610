// Draws text into a picture with a built-in font (capital letters).
#pragma once

#include <string_view>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Black on white, 6x8 dots of `size` pixels per letter, from (left, top); wrapped at spaces before `right`. Clipped to
/// the picture.
void write(RenderedPicture& picture, int left, int top, int right, int size, std::string_view text);

}  // namespace darwinop::twin
