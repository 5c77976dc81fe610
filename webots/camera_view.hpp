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

  /// 4 * width * height bytes at an address that never changes, overwritten by refresh(): controllers keep the pointer
  /// over steps, as they could in 2013.
  [[nodiscard]] const std::uint8_t* bgra() const { return shown_.data(); }

 private:
  void blacken();
  void stretch(const CameraFrame& frame);

  int width_, height_;
  std::unique_ptr<FrameSource> source_;
  std::vector<std::uint8_t> shown_;
  std::uint64_t sequence_ = 0;  // of the picture shown; 0: black
  bool reported_ = false;
};

}  // namespace darwinop::webots_api
