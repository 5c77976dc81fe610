// PNG files.
#pragma once

#include <string>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Throws std::runtime_error on a write error.
void writePng(const std::string& file, const RenderedPicture& picture);
/// Throws std::runtime_error for an unreadable file or one that is not a PNG.
RenderedPicture readPng(const std::string& file);

}  // namespace darwinop::twin
