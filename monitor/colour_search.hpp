// Interface of the colour search in camera frames. The program supplies it, so that the monitor does not use vision.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/colour_search.hpp"
#include "hal/frame_source.hpp"

namespace darwinop::monitor {

/// Parameters of one colour search, those of the vision manager.
struct ColourQuery {
  ColourThresholds colour{};
  PercentLimits limits{};
  bool operator==(const ColourQuery&) const = default;
};

/// Result of one search in one frame.
struct ColourMatch {
  std::uint64_t picture = 0;                     // sequence number of the frame
  int width = 0, height = 0;                     // of the frame, pixels
  std::optional<Pixel> centre;                   // nullopt: the share of the colour is outside the limits
  std::uint64_t pixels = 0;                      // of the colour, after noise removal
  int left = 0, top = 0, right = 0, bottom = 0;  // bounding box, inclusive; undefined if pixels is 0
  std::vector<std::uint8_t>
      mask;  // one bit per pixel, rows of (width + 7) / 8 bytes; the lowest bit is the leftmost pixel
};

/// setSearches() and resultOf() are called by one thread, process() by one other.
class ColourSearch {
 public:
  static constexpr std::size_t kMost = 8;  // searches: one for each observer

  virtual ~ColourSearch() = default;
  /// Takes effect with the next frame; searches beyond kMost are ignored.
  virtual void setSearches(const std::vector<ColourQuery>& searches) = 0;
  virtual void process(const CameraFrame& frame) noexcept = 0;
  /// Nullopt: that frame was not searched for it, or its result is no longer kept.
  [[nodiscard]] virtual std::optional<ColourMatch> resultOf(const ColourQuery& search, std::uint64_t picture) const = 0;
};

}  // namespace darwinop::monitor
