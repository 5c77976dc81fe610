// Writes capital letters into a picture, where no font is to be had.
#pragma once

#include <string_view>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Black on white, `size` pixels a dot, 6x8 dots a letter, from this pixel on; broken at spaces before `right`. What
/// lies outside the picture is left out.
void write(Picture& picture, int left, int top, int right, int size, std::string_view text);

}  // namespace darwinop::twin
