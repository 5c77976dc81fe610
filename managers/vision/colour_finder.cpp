// Finds the centre of a colour in a picture.
#include "managers/vision/colour_finder.hpp"

namespace darwinop::vision {

ColourFinder::ColourFinder(int width, int height, const Thresholds& wanted, PercentLimits limits,
                           Instructions instructions)
    : test_{compile(wanted)},
      limits_{limits},
      classify_{classifierFor(instructions)},
      mask_{width, height},
      scratch_{width, height} {}

std::optional<Pixel> ColourFinder::find(std::span<const std::uint8_t> bgra) {
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(width());
  const std::size_t pixels = static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  if (bgra.size() != 4 * pixels || test_.nothing) {
    mask_.clear();
    return {};
  }
  const std::uint8_t* from = bgra.data();
  for (int y = 0; y < height(); ++y, from += row_bytes) classify_(test_, from, width(), mask_.row(y).data());

  const Moments found = open(mask_, scratch_);
  const auto count = static_cast<double>(found.count), all = static_cast<double>(pixels);
  if (found.count == 0 || count <= all * limits_.min / 100 || count > all * limits_.max / 100) return {};
  return Pixel{static_cast<int>(found.x / found.count), static_cast<int>(found.y / found.count)};
}

}  // namespace darwinop::vision
