// Picture sizes of remote control, as crops of the camera's picture.
#pragma once

#include <algorithm>
#include <array>

namespace darwinop::remote {

struct ImageSize {
  int width = 0, height = 0;  // pixels
  bool operator==(const ImageSize&) const = default;
};

/// Size of the camera's picture. A smaller image is its centre crop, not a scaled copy: its field of view is narrower.
inline constexpr ImageSize kWholeImage{320, 240};
inline constexpr std::array kImageWidths{320, 160, 80, 40}, kImageHeights{240, 120, 60, 30};  // in any combination

constexpr bool isImageSize(ImageSize size) {
  return std::ranges::find(kImageWidths, size.width) != kImageWidths.end() &&
         std::ranges::find(kImageHeights, size.height) != kImageHeights.end();
}

/// First column and row of a crop in the whole image.
constexpr int leftOf(ImageSize size) {
  return (kWholeImage.width - size.width) / 2;
}
constexpr int topOf(ImageSize size) {
  return (kWholeImage.height - size.height) / 2;
}

/// JPEG quality, as in 2013: at a higher one the whole image would not fit into a cycle.
constexpr int qualityOf(ImageSize size) {
  return size == kWholeImage ? 65 : 80;
}

}  // namespace darwinop::remote
