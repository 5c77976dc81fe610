#include "webots/camera_view.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace darwinop::webots_api {
namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

CameraView::CameraView(int width, int height, std::unique_ptr<FrameSource> source)
    : width_{width},
      height_{height},
      source_{std::move(source)},
      shown_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  blacken();
}

std::string CameraView::refresh() {
  if (source_ == nullptr) return {};
  const CameraFrame frame = source_->newest();
  // A controller would follow an old picture as if it were current.
  const std::uint64_t sequence = source_->health().seeing ? frame.sequence : 0;
  if (std::exchange(sequence_, sequence) == sequence) return {};
  if (sequence == 0) {
    blacken();
    return {};
  }
  if (frame.width == width_ && frame.height == height_) {
    std::ranges::copy(frame.bgra.first(shown_.size()), shown_.begin());
    return {};
  }
  stretch(frame);
  if (std::exchange(reported_, true)) return {};
  return "Camera: pictures of " + sizeText(frame.width, frame.height) + " are stretched to " +
         sizeText(width_, height_) + "; to avoid this, set camera_width = " + std::to_string(frame.width) +
         ", camera_height = " + std::to_string(frame.height) + " in config.ini";
}

void CameraView::blacken() {
  std::ranges::fill(shown_, std::uint8_t{0});
  for (std::size_t alpha = 3; alpha < shown_.size(); alpha += 4) shown_[alpha] = 255;
}

// Nearest-neighbour scaling.
void CameraView::stretch(const CameraFrame& frame) {
  std::uint8_t* into = shown_.data();
  for (int row = 0; row < height_; ++row) {
    const int from_row = (2 * row + 1) * frame.height / (2 * height_);
    const std::uint8_t* const line = frame.bgra.data() + 4 * static_cast<std::ptrdiff_t>(from_row) * frame.width;
    for (int column = 0; column < width_; ++column, into += 4)
      std::memcpy(into, line + 4 * static_cast<std::ptrdiff_t>((2 * column + 1) * frame.width / (2 * width_)), 4);
  }
}

}  // namespace darwinop::webots_api
