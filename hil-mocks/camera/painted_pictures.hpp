// What is painted for the virtual camera, for a program of ours that looks into the file: it needs no library
// preloaded, takes the camera from nobody, and learns why there are no pictures.
#pragma once

#include <string>
#include <vector>

#include "hal/frame_source.hpp"
#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil {

/// YUYV of 320x240; pictures of another size, which a program may have set, are not shown. Asks for 15 pictures a
/// second as long as it is looked at.
class PaintedPictures final : public FrameSource {
 public:
  static constexpr std::uint32_t kWidth = 320, kHeight = 240;

  /// `set_size`: nobody else looks, so that the size is 320x240 again. Throws std::runtime_error: no file of this
  /// version.
  PaintedPictures(const std::string& path, bool set_size);
  ~PaintedPictures() override;
  PaintedPictures(const PaintedPictures&) = delete;
  PaintedPictures& operator=(const PaintedPictures&) = delete;

  CameraFrame newest() override;
  [[nodiscard]] CameraHealth health() const override;
  /// Empty: the painter paints. By any thread.
  [[nodiscard]] std::string trouble() const;

 private:
  FrameFile* file_;
  std::vector<std::uint8_t> spare_ = std::vector<std::uint8_t>(std::size_t{2} * kWidth * kHeight), shown_ = spare_;
  CameraFrame frame_{};
  std::uint64_t frames_ = 0;
};

}  // namespace darwinop::hil
