// An open V4L2 device that has been seen to be a camera.
#pragma once

#include <sys/ioctl.h>

#include <cerrno>
#include <string>

namespace darwinop::v4l2 {

/// 0, or the errno. Names of requests: linux/videodev2.h; only such as Linux 2.6.31 has.
template <class Argument>
[[nodiscard]] int request(int fd, unsigned long what, Argument& argument) noexcept {
  int result = 0;
  do result = ::ioctl(fd, what, &argument);
  while (result < 0 && errno == EINTR);
  return result < 0 ? errno : 0;
}

class Device {
 public:
  /// Throws CameraRefused: it is not there, not ours, or no camera that streams.
  explicit Device(std::string path);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] int fd() const noexcept { return fd_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  int fd_ = -1;
};

}  // namespace darwinop::v4l2
