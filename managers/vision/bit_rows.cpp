// Erosion and dilation of a bit mask, 64 pixels per word.
#include "managers/vision/bit_rows.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string>

namespace darwinop::vision {

namespace {

using Word = std::uint64_t;
using Row = std::span<Word>;

int checkedSide(int side, const char* what) {
  if (side < 1 || side > BitRows::kMaxSide)
    throw std::invalid_argument(std::string{what} + " of an image is " + std::to_string(side) +
                                " pixels; must be 1 to " + std::to_string(BitRows::kMaxSide));
  return side;
}

/// Combines each pixel with both its neighbours in the row; pixels beyond the row count as 0.
template <class Combine>
void acrossRow(std::span<const Word> from, Row to, Combine combine) {
  Word before = 0, here = from[0];
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Word after = i + 1 < from.size() ? from[i + 1] : 0;
    to[i] = combine(combine(here, here << 1 | before >> 63), here >> 1 | after << 63);
    before = here;
    here = after;
  }
}

constexpr auto kAll = [](Word a, Word b) { return a & b; };
constexpr auto kAny = [](Word a, Word b) { return a | b; };

bool isEmpty(std::span<const Word> row) {
  Word any = 0;
  for (const Word word : row) any |= word;
  return any == 0;
}

void clearRow(Row row) {
  std::ranges::fill(row, 0);
}

/// Adds the pixels of a row, run by run: after a dilation a word has at most 16 runs, mostly one.
void add(Moments& sum, std::span<const Word> row, unsigned y) {
  std::uint64_t count = 0, twice_x = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    Word word = row[i];
    while (word != 0) {
      const auto first = static_cast<unsigned>(std::countr_zero(word));
      const auto length = static_cast<unsigned>(std::countr_one(word >> first));
      count += length;
      twice_x += std::uint64_t{length} * (2 * (64 * i + first) + length - 1);
      if (first + length == 64) break;
      word &= ~Word{0} << (first + length);
    }
  }
  sum.count += count;
  sum.x += twice_x / 2;
  sum.y += count * y;
}

}  // namespace

BitRows::BitRows(int width, int height)
    : width_{checkedSide(width, "the width")},
      height_{checkedSide(height, "the height")},
      words_per_row_{(static_cast<std::size_t>(width) + 63) / 64},
      words_(words_per_row_ * static_cast<std::size_t>(height)) {}

bool BitRows::at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
  return (row(y)[static_cast<std::size_t>(x) / 64] >> (x % 64) & 1) != 0;
}

void BitRows::clear() {
  std::ranges::fill(words_, 0);
}

Moments open(BitRows& mask, BitRows& scratch) {
  Moments sum;
  const int last = mask.height() - 1;
  if (last < 2 || mask.width() < 3) return mask.clear(), sum;  // all border

  // Erosion: horizontal in place, then vertical into scratch, with the horizontal dilation of each row. Pixels beyond
  // the row count as 0, which clears the first and last column.
  for (int y = 0; y <= last; ++y)
    if (const Row row = mask.row(y); !isEmpty(row)) acrossRow(row, row, kAll);
  const std::size_t words = mask.row(0).size();
  const Word last_columns =
      ~Word{0} >> (63 - (mask.width() - 1) % 64) >> 1;  // all columns of the last word but the last
  clearRow(scratch.row(0));
  clearRow(scratch.row(last));
  for (int y = 1; y < last; ++y) {
    const Row above = mask.row(y - 1), here = mask.row(y), below = mask.row(y + 1), to = scratch.row(y);
    for (std::size_t i = 0; i < words; ++i) to[i] = above[i] & here[i] & below[i];
    if (isEmpty(to)) continue;
    acrossRow(to, to, kAny);
    to.front() &= ~Word{1};
    to.back() &= last_columns;
  }

  // Vertical dilation.
  clearRow(mask.row(0));
  clearRow(mask.row(last));
  for (int y = 1; y < last; ++y) {
    const Row above = scratch.row(y - 1), here = scratch.row(y), below = scratch.row(y + 1), to = mask.row(y);
    for (std::size_t i = 0; i < words; ++i) to[i] = above[i] | here[i] | below[i];
    add(sum, to, static_cast<unsigned>(y));
  }
  return sum;
}

}  // namespace darwinop::vision
