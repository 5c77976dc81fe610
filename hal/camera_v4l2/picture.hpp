// A captured picture, and the counters of the camera.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "hal/camera_v4l2/negotiate.hpp"
#include "hal/frame_source.hpp"
#include "hal/pixels/yuyv_image.hpp"

namespace darwinop::v4l2 {

struct Picture {
  CameraFrame asFrame() const noexcept { return {sequence, time, size.width, size.height, bgra, yuyv}; }

  std::uint64_t sequence = 0;
  Nanos time{0};
  Size size;
  std::vector<std::uint8_t> bgra, yuyv;  // one of them is empty
};

[[nodiscard]] inline Picture blackPicture(Size size, PictureForm form) {
  Picture black{0, Nanos{0}, size, {}, {}};
  const std::size_t height = static_cast<std::size_t>(size.height);
  if (form == PictureForm::kYuyv) {
    black.yuyv.resize(pixels::yuyvRowBytes(size.width) * height);
    for (std::size_t chroma = 1; chroma < black.yuyv.size(); chroma += 2) black.yuyv[chroma] = 128;
    return black;
  }
  black.bgra.resize(4u * static_cast<std::size_t>(size.width) * height);
  for (std::size_t alpha = 3; alpha < black.bgra.size(); alpha += 4) black.bgra[alpha] = 255;
  return black;
}

/// Written by the camera's thread, read by any.
struct Counters {
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);  // also on the robot's 32-bit CPU
  std::atomic<std::uint64_t> frames{0}, dropped{0}, damaged{0}, reopened{0};
  std::atomic<std::int64_t> last_frame_ns{0};  // CLOCK_MONOTONIC at the last complete picture
};

}  // namespace darwinop::v4l2
