// What the observers look for in the frames. The program supplies the search, so that the monitor needs no vision.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/colour_search.hpp"
#include "hal/frame_source.hpp"

namespace darwinop::monitor {

/// A colour to be found in the frames, as the vision manager finds it.
struct Search {
  ColourThresholds colour{};
  PercentLimits limits{};
  bool operator==(const Search&) const = default;
};

/// What a search found in one frame.
struct Found {
  std::uint64_t picture = 0;                     // its sequence
  int width = 0, height = 0;                     // of the picture
  std::optional<Pixel> centre;                   // nothing: too little of the colour, or too much
  std::uint64_t pixels = 0;                      // that have it, after noise is removed
  int left = 0, top = 0, right = 0, bottom = 0;  // bounding box, both ends included; of no use without pixels
  std::vector<std::uint8_t> mask;  // a bit a pixel, row by row, (width + 7) / 8 bytes each; the lowest is the left one
};

/// want() and found() are called by one thread, look() by one other.
class ColourSearch {
 public:
  static constexpr std::size_t kMost = 8;  // searches: there are no more observers

  virtual ~ColourSearch() = default;
  /// From the next frame on; those beyond kMost are ignored.
  virtual void want(const std::vector<Search>& searches) = 0;
  virtual void look(const CameraFrame& frame) noexcept = 0;
  /// Nothing: that frame was not searched for it, or is long gone.
  [[nodiscard]] virtual std::optional<Found> found(const Search& search, std::uint64_t picture) const = 0;
};

}  // namespace darwinop::monitor
