// Picture buffer of webots::Camera: constant size, independent of what the camera delivers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hal/frame_source.hpp"

namespace darwinop::webots_api {

/// Used by the controller's thread.
class CameraView {
 public:
  /// Without a source the picture stays black.
  CameraView(int width, int height, std::unique_ptr<FrameSource> source);

  /// Takes the newest picture. Returns a message for the user if its size is not as requested; empty: it is, or that
  /// was reported before.
  [[nodiscard]] std::string refresh();

  /// 4 * width * height bytes, unchanged until the next refresh().
  [[nodiscard]] const std::uint8_t* bgra() const { return shown_; }

 private:
  void stretch(const CameraFrame& frame);

  int width_, height_;
  std::unique_ptr<FrameSource> source_;
  std::vector<std::uint8_t> black_, stretched_;
  const std::uint8_t* shown_;
  bool reported_ = false;
};

}  // namespace darwinop::webots_api
