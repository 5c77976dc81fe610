// A camera picture in five passes, one buffer each, in plain C++: as upstream's capture goes about it, with BGRA at the
// end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace darwinop::bench {

class FivePasses {
 public:
  FivePasses(int width, int height)
      : width_{static_cast<std::size_t>(width)},
        height_{static_cast<std::size_t>(height)},
        copy_(2 * width_ * height_),
        mirrored_(copy_.size()),
        turned_(copy_.size()),
        rgb_(3 * width_ * height_) {}

  /// `yuyv` without gaps, of an even width.
  void run(std::span<const std::uint8_t> yuyv, std::span<std::uint8_t> bgra) {
    std::memcpy(copy_.data(), yuyv.data(), copy_.size());
    for (std::size_t y = 0; y < height_; ++y) mirrorRow(&copy_[2 * width_ * y], &mirrored_[2 * width_ * y]);
    for (std::size_t y = 0; y < height_; ++y)
      std::memcpy(&turned_[2 * width_ * y], &mirrored_[2 * width_ * (height_ - 1 - y)], 2 * width_);
    for (std::size_t pixel = 0; pixel < width_ * height_; pixel += 2) pairToRgb(&turned_[2 * pixel], &rgb_[3 * pixel]);
    for (std::size_t pixel = 0; pixel < width_ * height_; ++pixel) {
      bgra[4 * pixel] = rgb_[3 * pixel + 2];
      bgra[4 * pixel + 1] = rgb_[3 * pixel + 1];
      bgra[4 * pixel + 2] = rgb_[3 * pixel];
      bgra[4 * pixel + 3] = 255;
    }
  }

 private:
  void mirrorRow(const std::uint8_t* from, std::uint8_t* to) const {
    for (std::size_t x = 0; x < width_; x += 2) {
      const std::uint8_t* pair = from + 2 * (width_ - 2 - x);
      to[2 * x] = pair[2];
      to[2 * x + 1] = pair[1];
      to[2 * x + 2] = pair[0];
      to[2 * x + 3] = pair[3];
    }
  }

  static void pairToRgb(const std::uint8_t* yuyv, std::uint8_t* rgb) {
    const auto limited = [](int value) { return static_cast<std::uint8_t>(std::clamp(value >> 8, 0, 255)); };
    const int u = yuyv[1] - 128, v = yuyv[3] - 128;
    for (int i = 0; i < 2; ++i) {
      const int y = yuyv[2 * i] << 8;
      rgb[3 * i] = limited(y + 359 * v);
      rgb[3 * i + 1] = limited(y - 88 * u - 183 * v);
      rgb[3 * i + 2] = limited(y + 454 * u);
    }
  }

  std::size_t width_, height_;
  std::vector<std::uint8_t> copy_, mirrored_, turned_, rgb_;
};

}  // namespace darwinop::bench
