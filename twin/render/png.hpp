// Pictures as PNG files.
#pragma once

#include <string>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

/// Throws std::runtime_error when the file cannot be written.
void writePng(const std::string& file, const Picture& picture);
/// Throws std::runtime_error for what is no PNG.
Picture readPng(const std::string& file);

}  // namespace darwinop::twin
