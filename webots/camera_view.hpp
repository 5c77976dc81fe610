// The picture that a controller holds: of the size that it was promised, whatever the camera gives.
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
  /// Without a source it stays black.
  CameraView(int width, int height, std::unique_ptr<FrameSource> source);

  /// Takes the newest picture. A sentence for the user when the picture is not as promised; empty: it is, or that was
  /// said before.
  [[nodiscard]] std::string refresh();

  /// 4 * width * height bytes, the same until the next refresh().
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
