// Draws scenes into pictures, without a display.
#pragma once

#include <memory>

#include "twin/render/picture.hpp"
#include "twin/render/scene.hpp"

namespace darwinop::twin {

/// How good a picture is, and what it costs at 320x240 without a graphics card: the robot's own eye 4 ms, shadows 12 ms
/// more, smooth edges twice that again.
enum class Quality { kEye, kFilm, kStill };

/// Any thread may use it, one at a time.
class Offscreen {
 public:
  static constexpr int kSmallest = 16, kLargest = 4096;  // pixels a side

  /// Throws std::runtime_error for a size out of range.
  static void checkSize(int width, int height);

  /// Throws NoGraphics, and std::runtime_error for a size out of range.
  Offscreen(const mjModel_& model, int width, int height, Quality quality);
  ~Offscreen();

  [[nodiscard]] Scene& scene() noexcept;
  /// The scene as it is now. The picture stays valid until the next call.
  const Picture& draw();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
