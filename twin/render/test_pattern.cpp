// Colour bars with text and a moving mark.
#include "twin/render/test_pattern.hpp"

#include <algorithm>
#include <array>

#include "twin/render/lettering.hpp"

namespace darwinop::twin {
namespace {

constexpr int kBars = 8;
constexpr std::array<std::array<std::uint8_t, 3>, kBars> kColours{
    {{255, 255, 255}, {255, 255, 0}, {0, 255, 255}, {0, 255, 0}, {255, 0, 255}, {255, 0, 0}, {0, 0, 255}, {0, 0, 0}}};
constexpr int kMark = 8;  // pixels per side

}  // namespace

RenderedPicture testPattern(int width, int height, std::string_view reason, unsigned count) {
  RenderedPicture picture{width, height};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::ranges::copy(kColours.at(static_cast<std::size_t>(x * kBars / width)), picture.at(x, y));
  const int size = std::max(1, width / 320);
  write(picture, 8 * size, height / 2, width - 8 * size, size, reason);

  const int places = std::max(width / kMark, 1);
  const int left = static_cast<int>(count % static_cast<unsigned>(places)) * kMark;
  for (int y = std::max(height - kMark, 0); y < height; ++y)
    for (int x = left; x < std::min(left + kMark, width); ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.at(x, y)[channel] = static_cast<std::uint8_t>(255 - picture.at(x, y)[channel]);
  return picture;
}

}  // namespace darwinop::twin
