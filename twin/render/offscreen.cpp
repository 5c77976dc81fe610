// Renders MuJoCo scenes into a buffer with EGL.
#include "twin/render/offscreen.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "twin/render/egl.hpp"

namespace darwinop::twin {
namespace {

Scene prepared(const mjModel& model, int width, int height, Quality quality) {
  Offscreen::checkSize(width, height);
  Scene scene{model};
  scene.reserve(width, height, quality == Quality::kStill, quality != Quality::kEye);
  scene.showShadows(quality != Quality::kEye);
  return scene;
}

/// MuJoCo's first row is the bottom one.
void flipVertically(RenderedPicture& picture) {
  for (int top = 0, bottom = picture.height - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(picture.at(0, top), picture.at(0, top + 1), picture.at(0, bottom));
}

}  // namespace

struct Offscreen::Parts {
  Scene scene;
  EglContext egl;
  mjrContext context{};
  RenderedPicture picture;

  Parts(const mjModel& model, int width, int height, Quality quality)
      : scene{prepared(model, width, height, quality)}, picture{width, height} {
    mjr_defaultContext(&context);
    mjr_makeContext(&scene.model(), &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    egl.release();
  }
  ~Parts() {
    if (egl.tryUse()) mjr_freeContext(&context);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
};

void Offscreen::checkSize(int width, int height) {
  for (const int side : {width, height})
    if (side < kSmallest || side > kLargest)
      throw std::runtime_error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                               " cannot be drawn: width and height are from " + std::to_string(kSmallest) + " to " +
                               std::to_string(kLargest) + " pixels");
}

Offscreen::Offscreen(const mjModel& model, int width, int height, Quality quality)
    : parts_{std::make_unique<Parts>(model, width, height, quality)} {}

Offscreen::~Offscreen() = default;

Scene& Offscreen::scene() noexcept {
  return parts_->scene;
}

const RenderedPicture& Offscreen::draw() {
  RenderedPicture& picture = parts_->picture;
  const mjrRect area{0, 0, picture.width, picture.height};
  parts_->egl.use();
  mjr_render(area, &parts_->scene.forSize(picture.width, picture.height), &parts_->context);
  mjr_readPixels(picture.rgb.data(), nullptr, area, &parts_->context);
  parts_->egl.release();
  flipVertically(picture);
  return picture;
}

}  // namespace darwinop::twin
