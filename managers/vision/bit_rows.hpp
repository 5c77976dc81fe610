// A picture of bits, 64 pixels a word: what is left of a mask when it is made thinner and thick again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace darwinop::vision {

/// Rows of words; pixel 0 is bit 0 of a row's first word. Bits behind the last pixel are 0.
class BitRows {
 public:
  /// Throws std::invalid_argument unless both are 1 to kMaxSide.
  BitRows(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::span<std::uint64_t> row(int y) { return {words_.data() + y * wordsPerRow(), wordsPerRow()}; }
  [[nodiscard]] std::span<const std::uint64_t> row(int y) const {
    return {words_.data() + y * wordsPerRow(), wordsPerRow()};
  }
  /// False outside of the picture.
  [[nodiscard]] bool at(int x, int y) const;
  void clear();

  /// So that neither a size in bytes nor a sum of coordinates overflows, on 32 bits either.
  static constexpr int kMaxSide = 16384;

 private:
  [[nodiscard]] std::size_t wordsPerRow() const { return words_per_row_; }

  int width_, height_;
  std::size_t words_per_row_;
  std::vector<std::uint64_t> words_;
};

/// Pixels that are set, and the sums of where they are.
struct Moments {
  std::uint64_t count = 0, x = 0, y = 0;
  bool operator==(const Moments&) const = default;
};

/// Erosion, then dilation, both by 3x3 and both with the picture's border cleared: what is thinner than three pixels
/// goes. `scratch` has the same size; both must be two pictures.
Moments open(BitRows& mask, BitRows& scratch);

}  // namespace darwinop::vision
