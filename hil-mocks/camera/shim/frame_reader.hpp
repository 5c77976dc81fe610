// Reader of the frame file.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil::shim {

/// Grey and without faults until there is a painter. Not thread-safe.
class FrameFileReader {
 public:
  /// Checks whether $DARWINOP_VIRTUAL_CAMERA names another file than the mapped one.
  void refresh();
  [[nodiscard]] CameraFault fault() const;
  /// Requests this size from the present and later painters.
  void want(std::uint32_t width, std::uint32_t height);
  /// The newest complete picture of this size, else grey. Marks the file as being read.
  void read(std::uint32_t width, std::uint32_t height, std::uint8_t* yuyv) const;

 private:
  /// Marks the file as being read, so that the painter paints.
  void ask() const;

  FrameFile* file_ = nullptr;
  dev_t device_ = 0;
  ino_t inode_ = 0;
  std::uint32_t width_ = 320, height_ = 240;
};

}  // namespace darwinop::hil::shim
