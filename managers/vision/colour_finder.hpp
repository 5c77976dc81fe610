// Colour detection: filter, morphological opening, centroid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/colour_search.hpp"
#include "managers/vision/bit_rows.hpp"
#include "managers/vision/classify.hpp"

namespace darwinop::vision {

using darwinop::PercentLimits;
using darwinop::Pixel;

/// Allocates only on construction. Not thread-safe.
class ColourFinder {
 public:
  /// Throws std::invalid_argument for sides outside 1 to BitRows::kMaxSide and for unsupported instructions.
  ColourFinder(int width, int height, const Thresholds&, PercentLimits = {}, Instructions = bestInstructions());

  /// Centroid of all matching pixels after opening (patches of at least 3x3, not necessarily connected), truncated to
  /// integers. Empty if they are too few or too many. `bgra`: 4 * width * height bytes; empty for any other size.
  std::optional<Pixel> find(std::span<const std::uint8_t> bgra);

  /// True if this pixel matched in the last find(), regardless of its result. False outside of the picture and before
  /// the first find().
  [[nodiscard]] bool isDetected(int x, int y) const { return mask_.at(x, y); }

  /// isDetected() of all pixels.
  [[nodiscard]] const BitRows& mask() const { return mask_; }

  void setThresholds(const Thresholds& wanted) { test_ = compile(wanted); }
  void setLimits(PercentLimits limits) { limits_ = limits; }
  [[nodiscard]] int width() const { return mask_.width(); }
  [[nodiscard]] int height() const { return mask_.height(); }

 private:
  ColourTest test_;
  PercentLimits limits_;
  Classify classify_;
  BitRows mask_, scratch_;
};

}  // namespace darwinop::vision
