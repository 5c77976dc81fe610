// Writer of the frame file: creates it, writes pictures, sets camera faults.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil {

struct PictureSize {
  int width, height;
  bool operator==(const PictureSize&) const = default;
};

inline constexpr const char* kNotAFrameFile = " exists and is not a frame file; choose another name";

/// Single painting thread; faults may be set by any thread. The destructor removes the file unless another painter
/// replaced it; an open camera then keeps its last picture.
class FramePainter {
 public:
  explicit FramePainter(std::string path);  // replaces an older frame file; throws std::runtime_error
  ~FramePainter();
  FramePainter(const FramePainter&) = delete;
  FramePainter& operator=(const FramePainter&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Size set by the program, or 320x240.
  [[nodiscard]] PictureSize wanted() const;
  /// Upright, 4 * width * height bytes; rotated by 180 degrees, like the robot's camera.
  void paint(PictureSize size, std::span<const std::uint8_t> bgra);
  /// 2 * width * height bytes, in camera orientation.
  void paintYuyv(PictureSize size, std::span<const std::uint8_t> yuyv);
  /// Pictures per second requested within the last two seconds: 30, 15 or 0.
  [[nodiscard]] int wantedRate() const;
  /// Reports to readers that there will be no pictures, and why. Once.
  void giveUp(const std::string& why);
  void setFault(CameraFault fault);
  [[nodiscard]] std::uint32_t painted() const;

 private:
  std::span<std::uint8_t> begin(PictureSize size);
  void complete();

  std::string path_;
  FrameFile* file_ = nullptr;
  dev_t device_ = 0;
  ino_t inode_ = 0;
};

}  // namespace darwinop::hil
