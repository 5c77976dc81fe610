// Opening a V4L2 device.
#include "hal/camera_v4l2/device.hpp"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <unistd.h>

#include <cstring>
#include <utility>

#include "hal/camera_v4l2/camera_error.hpp"

namespace darwinop::v4l2 {
namespace {

void checkCapabilities(int fd, const std::string& path) {
  v4l2_capability able{};
  const int error = request(fd, VIDIOC_QUERYCAP, able);
  // A device without V4L2 returns ENOTTY; old drivers return EINVAL.
  if (error == ENOTTY || error == EINVAL) throw CameraRefused{CameraError::kNotACamera, path, std::strerror(error)};
  if (error != 0) refuse(path, error);
  // One camera may have several device nodes, one of them for capture. Linux 2.6.31 does not distinguish them.
  const auto caps = (able.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? able.device_caps : able.capabilities;
  if ((caps & V4L2_CAP_VIDEO_CAPTURE) == 0) throw CameraRefused{CameraError::kNotACamera, path, kNoVideoCapture};
  if ((caps & V4L2_CAP_STREAMING) == 0) throw CameraRefused{CameraError::kNoStreaming, path};
}

}  // namespace

V4l2Device::V4l2Device(std::string path) : path_{std::move(path)} {
  fd_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (fd_ < 0) refuse(path_, errno);
  try {
    checkCapabilities(fd_, path_);
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

V4l2Device::~V4l2Device() {
  ::close(fd_);
}

}  // namespace darwinop::v4l2
