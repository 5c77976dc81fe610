// Reads the painter's file directly, without the preloaded shim and without occupying the camera; also reports why
// there are no pictures.
#pragma once

#include <string>
#include <vector>

#include "hal/frame_source.hpp"
#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil {

/// YUYV of 320x240; ignores pictures of another size, which a program may have set. Requests 15 pictures per second
/// while newest() is called.
class PaintedPictures final : public FrameSource {
 public:
  static constexpr std::uint32_t kWidth = 320, kHeight = 240;

  /// `set_size`: there is no other reader, so reset the size to 320x240. Throws std::runtime_error if there is no file
  /// of this version.
  PaintedPictures(const std::string& path, bool set_size);
  ~PaintedPictures() override;
  PaintedPictures(const PaintedPictures&) = delete;
  PaintedPictures& operator=(const PaintedPictures&) = delete;

  CameraFrame newest() override;
  [[nodiscard]] CameraHealth health() const override;
  /// Why there are no pictures; empty: no error. Any thread.
  [[nodiscard]] std::string error() const;

 private:
  FrameFile* file_;
  std::vector<std::uint8_t> spare_ = std::vector<std::uint8_t>(std::size_t{2} * kWidth * kHeight), shown_ = spare_;
  CameraFrame frame_{};
  std::uint64_t frames_ = 0;
};

}  // namespace darwinop::hil
