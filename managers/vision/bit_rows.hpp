// Bit mask, 64 pixels per word, with morphological opening.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace darwinop::vision {

/// Rows of words; pixel 0 is bit 0 of a row's first word. Padding bits are 0.
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

  /// Prevents overflow of sizes in bytes and of coordinate sums, also with 32 bits.
  static constexpr int kMaxSide = 16384;

 private:
  [[nodiscard]] std::size_t wordsPerRow() const { return words_per_row_; }

  int width_, height_;
  std::size_t words_per_row_;
  std::vector<std::uint64_t> words_;
};

/// Number of set pixels and sums of their coordinates.
struct Moments {
  std::uint64_t count = 0, x = 0, y = 0;
  bool operator==(const Moments&) const = default;
};

/// Morphological opening: erosion, then dilation, both 3x3 with the border cleared; removes structures thinner than
/// three pixels. `scratch` must be another mask of the same size.
Moments open(BitRows& mask, BitRows& scratch);

}  // namespace darwinop::vision
