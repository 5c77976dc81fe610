// The painting end of the frame file: makes the file, fills it with pictures, sets what is wrong with the camera.
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

/// One thread paints; faults may be set by any. The file is removed at the end, unless another painter replaced it; a
/// camera that is open then keeps its last picture.
class FramePainter {
 public:
  explicit FramePainter(std::string path);  // replaces what is there; throws std::runtime_error
  ~FramePainter();
  FramePainter(const FramePainter&) = delete;
  FramePainter& operator=(const FramePainter&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// What the program has set, or 320x240.
  [[nodiscard]] PictureSize wanted() const;
  /// Upright, 4 * width * height bytes; turned by 180 degrees on its way, as the robot's camera hangs.
  void paint(PictureSize size, std::span<const std::uint8_t> bgra);
  /// 2 * width * height bytes, as the camera sends them.
  void paintYuyv(PictureSize size, std::span<const std::uint8_t> yuyv);
  /// Pictures a second that somebody wants who has looked within the last two seconds: 30, 15 or 0.
  [[nodiscard]] int wantedRate() const;
  /// There will be no pictures, for programs that look into the file: `why`, in words. Once.
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
