// Pictures made for the tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace darwinop::vision {

struct Rgb {
  std::uint8_t r, g, b;
};

/// Red, well inside of the thresholds that are the default.
inline constexpr Rgb kRed{200, 10, 10};
inline constexpr Rgb kGreen{20, 150, 30};

class Picture {
 public:
  Picture(int width, int height, Rgb everywhere = kGreen)
      : width_{width}, height_{height}, bytes_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    box(0, 0, width, height, everywhere);
  }
  void set(int x, int y, Rgb colour) {
    const std::uint8_t pixel[] = {colour.b, colour.g, colour.r, 255};
    std::memcpy(bytes_.data() +
                    4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)),
                pixel, 4);
  }
  /// From the corner (x, y).
  Picture& box(int x, int y, int width, int height, Rgb colour = kRed) {
    for (int row = y; row < y + height; ++row)
      for (int column = x; column < x + width; ++column) set(column, row, colour);
    return *this;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] const std::uint8_t* data() const { return bytes_.data(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

/// Boxes of a few colours, so that there is something to make thinner, and single pixels of any colour.
inline Picture randomPicture(int width, int height, std::mt19937& dice) {
  const auto up_to = [&](int most) { return std::uniform_int_distribution<int>{0, most}(dice); };
  const auto any = [&] { return static_cast<std::uint8_t>(up_to(255)); };
  Picture picture{width, height, {any(), any(), any()}};
  for (int boxes = up_to(12); boxes > 0; --boxes) {
    const int x = up_to(width - 1), y = up_to(height - 1);
    picture.box(x, y, 1 + up_to(width - x - 1), 1 + up_to(height - y - 1),
                up_to(2) == 0 ? Rgb{any(), any(), any()} : kRed);
  }
  for (int dots = up_to(width * height / 4); dots > 0; --dots)
    picture.set(up_to(width - 1), up_to(height - 1), {any(), any(), any()});
  return picture;
}

}  // namespace darwinop::vision
