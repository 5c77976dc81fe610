// Encodes a black picture.
#include "remote/jpeg/black_image.hpp"

namespace darwinop::remote {

std::vector<std::uint8_t> blackImage(JpegEncoder& encoder) {
  const std::vector<std::uint8_t> bgra(std::size_t{4} * kWholeImage.width * kWholeImage.height);
  std::vector<std::uint8_t> jpeg(encoder.mostBytes());
  jpeg.resize(encoder.encode({0, Nanos{0}, kWholeImage.width, kWholeImage.height, bgra, {}}, jpeg));
  return jpeg;
}

}  // namespace darwinop::remote
