// Which pictures a client can have, and which part of the camera's they are.
#pragma once

#include <algorithm>
#include <array>

namespace darwinop::remote {

struct ImageSize {
  int width = 0, height = 0;  // pixels
  bool operator==(const ImageSize&) const = default;
};

/// The camera's. A client's image is its middle, not a smaller copy of it: a small image has a narrow field of view.
inline constexpr ImageSize kWholeImage{320, 240};
inline constexpr std::array kImageWidths{320, 160, 80, 40}, kImageHeights{240, 120, 60, 30};  // each with each

constexpr bool isImageSize(ImageSize size) {
  return std::ranges::find(kImageWidths, size.width) != kImageWidths.end() &&
         std::ranges::find(kImageHeights, size.height) != kImageHeights.end();
}

/// First column and row of an image in the whole one.
constexpr int leftOf(ImageSize size) {
  return (kWholeImage.width - size.width) / 2;
}
constexpr int topOf(ImageSize size) {
  return (kWholeImage.height - size.height) / 2;
}

/// What clients have always been sent: the whole image would be too long for a cycle at more.
constexpr int qualityOf(ImageSize size) {
  return size == kWholeImage ? 65 : 80;
}

}  // namespace darwinop::remote
