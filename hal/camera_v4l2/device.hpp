// An open V4L2 capture device.
#pragma once

#include <sys/ioctl.h>

#include <cerrno>
#include <string>

namespace darwinop::v4l2 {

/// Detail of CameraError::kNotACamera.
inline constexpr const char* kNoVideoCapture = "no video capture";

/// ioctl(); returns 0 or the errno. Requests: those of linux/videodev2.h that Linux 2.6.31 has.
template <class Argument>
[[nodiscard]] int request(int fd, unsigned long what, Argument& argument) noexcept {
  int result = 0;
  do result = ::ioctl(fd, what, &argument);
  while (result < 0 && errno == EINTR);
  return result < 0 ? errno : 0;
}

class V4l2Device {
 public:
  /// Throws CameraRefused if it is absent, not permitted, or not a streaming camera.
  explicit V4l2Device(std::string path);
  ~V4l2Device();
  V4l2Device(const V4l2Device&) = delete;
  V4l2Device& operator=(const V4l2Device&) = delete;

  [[nodiscard]] int fd() const noexcept { return fd_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  int fd_ = -1;
};

}  // namespace darwinop::v4l2
