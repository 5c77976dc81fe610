// Where in a picture the colour is: filter, noise taken away, centre of what is left.
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

/// Takes memory when it is made, and none afterwards. One thread at a time.
class ColourFinder {
 public:
  /// Throws std::invalid_argument for sides that are not 1 to BitRows::kMaxSide, and for instructions that this
  /// processor lacks.
  ColourFinder(int width, int height, const Thresholds&, PercentLimits = {}, Instructions = bestInstructions());

  /// Mean of all pixels that have the colour and are part of a patch of at least 3x3, cut to whole pixels; they need
  /// not hang together. Nothing if they are too few, too many or none at all. `bgra` has 4 * width * height bytes; of
  /// any other number none is read, and nothing is found.
  std::optional<Pixel> find(std::span<const std::uint8_t> bgra);

  /// Whether the last find() took this pixel for the colour, also where it then found too few or too many. False
  /// outside of the picture and before the first find().
  [[nodiscard]] bool isDetected(int x, int y) const { return mask_.at(x, y); }

  /// All of isDetected().
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
