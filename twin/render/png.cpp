// Reads and writes PNG files with lodepng.
#include "twin/render/png.hpp"

#include <lodepng.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "hal/write_text_file.hpp"

namespace darwinop::twin {
namespace {

[[noreturn]] void fail(const char* what, const std::string& file, unsigned error) {
  throw std::runtime_error(std::string{"cannot "} + what + " the picture " + file + ": " + lodepng_error_text(error));
}

}  // namespace

void writePng(const std::string& file, const RenderedPicture& picture) {
  std::vector<unsigned char> bytes;
  const unsigned error = lodepng::encode(bytes, picture.rgb, static_cast<unsigned>(picture.width),
                                         static_cast<unsigned>(picture.height), LCT_RGB);
  if (error != 0) fail("write", file, error);
  writeTextFile(file, std::string{bytes.begin(), bytes.end()});  // lodepng's own writer does not notice a full disk
}

RenderedPicture readPng(const std::string& file) {
  RenderedPicture picture;
  unsigned width = 0, height = 0;
  const unsigned error = lodepng::decode(picture.rgb, width, height, file, LCT_RGB);
  if (error != 0) fail("read", file, error);
  picture.width = static_cast<int>(width);
  picture.height = static_cast<int>(height);
  return picture;
}

}  // namespace darwinop::twin
