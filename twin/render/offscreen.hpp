// Offscreen renderer: draws a scene into a picture without a display.
#pragma once

#include <memory>

#include "twin/render/picture.hpp"
#include "twin/render/scene.hpp"

namespace darwinop::twin {

/// Picture quality. Cost at 320x240 with software rendering: kEye 4 ms, shadows 12 ms more, antialiasing 24 ms more.
enum class Quality { kEye, kFilm, kStill };

/// May be used from any thread, by one thread at a time.
class Offscreen {
 public:
  static constexpr int kSmallest = 16, kLargest = 4096;  // pixels per side

  /// Throws std::runtime_error for a size out of range.
  static void checkSize(int width, int height);

  /// Throws NoGraphics, and std::runtime_error for a size out of range.
  Offscreen(const mjModel_& model, int width, int height, Quality quality);
  ~Offscreen();

  [[nodiscard]] Scene& scene() noexcept;
  /// Renders the present scene. The picture is valid until the next call.
  const RenderedPicture& draw();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
