// Camera frames for tests, and what a decoder makes of their JPEGs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "remote/jpeg/decoder.hpp"
#include "remote/jpeg/encoder.hpp"

namespace darwinop::remote {

using PixelBytes = std::vector<std::uint8_t>;

inline std::size_t pixelsOf(ImageSize size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

/// What a camera sees, in both forms: BGRA is made of YUYV, as a controller's is.
struct Scene {
  /// `colour`: blue, green, red at a column and a row of the upright picture.
  template <class Colour>
  explicit Scene(Colour&& colour) : yuyv(2 * pixelsOf(kWholeImage)), bgra(4 * pixelsOf(kWholeImage)) {
    std::uint8_t* pixel = bgra.data();
    for (int row = 0; row < kWholeImage.height; ++row)
      for (int column = 0; column < kWholeImage.width; ++column, pixel += 4) {
        const auto bgr = colour(column, row);
        for (int i = 0; i < 3; ++i)
          pixel[i] = static_cast<std::uint8_t>(std::clamp(static_cast<double>(bgr[i]), 0.0, 255.0));
        pixel[3] = 255;
      }
    const auto [width, height] = kWholeImage;
    const std::size_t stride = pixels::yuyvRowBytes(width);
    pixels::bgraToYuyvRotated(bgra, width, height, yuyv, stride);
    pixels::yuyvToBgraRotated({yuyv, width, height, stride}, bgra);
    for (int pixel_number = width * height - 1; pixel_number >= 0; --pixel_number) {
      const std::uint8_t* pair = yuyv.data() + pixel_number / 2 * 4;
      const double luma = pair[pixel_number % 2 * 2], u = pair[1] - 128, v = pair[3] - 128;
      for (const double value : {luma + 1.772 * u, luma - 0.344136 * u - 0.714136 * v, luma + 1.402 * v})
        colours.push_back(static_cast<float>(std::clamp(value, 0.0, 255.0)));
    }
  }

  [[nodiscard]] CameraFrame frame(PictureForm form) const {
    CameraFrame frame{1, Nanos{0}, kWholeImage.width, kWholeImage.height, {}, {}};
    (form == PictureForm::kYuyv ? frame.yuyv : frame.bgra) = form == PictureForm::kYuyv ? yuyv : bgra;
    return frame;
  }
  /// Blue, green, red.
  [[nodiscard]] const float* at(int column, int row) const {
    return colours.data() + 3 * (static_cast<std::ptrdiff_t>(row) * kWholeImage.width + column);
  }

  PixelBytes yuyv, bgra;
  std::vector<float> colours;  // of YUYV by JFIF's formula: BGRA rounds down, and is half a count too dark
};

/// A room with edges, slopes and grain: neither as smooth as paper nor as rough as noise.
inline Scene room() {
  return Scene{[](int x, int y) {
    const double grain = (x * 7919 + y * 104729) % 13 - 6.0;
    const bool line = x % 37 < 3 || y % 23 < 2;
    const bool ball = std::hypot(x - 170, y - 110) < 31;
    const double light = 60 + 0.4 * x + 0.2 * y + 30 * std::sin(x * 0.07) * std::cos(y * 0.05) + grain;
    return ball   ? std::array{30 + grain, 90 + 0.3 * y, 220 + grain}
           : line ? std::array{220.0, 225.0, 230.0}
                  : std::array{0.5 * light, light, 0.7 * light};
  }};
}

inline PixelBytes encoded(JpegEncoder& encoder, const CameraFrame& frame) {
  PixelBytes jpeg(encoder.mostBytes());
  jpeg.resize(encoder.encode(frame, jpeg));
  return jpeg;
}

inline PixelBytes decoded(const PixelBytes& jpeg, ImageSize size) {
  PixelBytes bgra(4 * pixelsOf(size));
  const char* wrong = decodeJpeg(jpeg, size, bgra);
  EXPECT_EQ(wrong, nullptr) << wrong;
  return bgra;
}

/// In dB over all three colours, against the middle of the scene, or what is `right` and `down` of it.
inline double psnr(const Scene& scene, const PixelBytes& bgra, ImageSize size, int right = 0, int down = 0) {
  double squares = 0;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      const std::uint8_t* is = bgra.data() + 4 * (static_cast<std::ptrdiff_t>(row) * size.width + column);
      const float* was = scene.at(leftOf(size) + right + column, topOf(size) + down + row);
      for (int i = 0; i < 3; ++i) squares += std::pow(is[i] - was[i], 2);
    }
  return 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(pixelsOf(size)) / squares);
}

}  // namespace darwinop::remote
