// The reading end of the frame file.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil::shim {

/// Grey, and no fault, as long as nobody paints. Not thread-safe.
class FrameReader {
 public:
  /// Looks whether $DARWINOP_VIRTUAL_CAMERA names another file than the one mapped: a painter may have come.
  void refresh();
  [[nodiscard]] CameraFault fault() const;
  /// Asks the painter for this size. Remembered for the next painter.
  void want(std::uint32_t width, std::uint32_t height);
  /// The newest whole picture, and a word to the painter that somebody looks; grey when there is none of this size.
  void read(std::uint32_t width, std::uint32_t height, std::uint8_t* yuyv) const;

 private:
  /// Somebody looks: there is a point in painting.
  void ask() const;

  FrameFile* file_ = nullptr;
  dev_t device_ = 0;
  ino_t inode_ = 0;
  std::uint32_t width_ = 320, height_ = 240;
};

}  // namespace darwinop::hil::shim
