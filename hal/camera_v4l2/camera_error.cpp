// Error messages for the camera.
#include "hal/camera_v4l2/camera_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace darwinop::v4l2 {
namespace {

constexpr const char* kList = "`v4l2-ctl --list-devices` lists them";

std::string otherCameras(const std::string& device, const std::string& dev) {
  std::vector<std::string> others = videoDevices(dev);
  std::erase(others, device);
  if (others.empty()) return "no other video device found; check the camera's USB cable (`lsusb` must list it)";
  std::string text = "available video devices:";
  for (const std::string& other : others) text += " " + other;
  return text + "; " + kList;
}

std::string inBrackets(const std::string& detail) {
  return detail.empty() ? std::string{} : " (" + detail + ")";
}

}  // namespace

CameraError cameraErrorOf(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case ENODEV:
    case ENXIO:
      return CameraError::kAbsent;
    case EACCES:
    case EPERM:
      return CameraError::kForbidden;
    case EBUSY:
      return CameraError::kBusy;
    case ENOTTY:
    case EISDIR:
    case ELOOP:
      return CameraError::kNotACamera;
    case ENOSPC:
      return CameraError::kNoBandwidth;
    case ENOMEM:
      return CameraError::kOutOfMemory;
    case EIO:
    case EPROTO:
      return CameraError::kReadErrors;
    default:
      return CameraError::kOther;
  }
}

std::string explain(CameraError kind, const std::string& device, const std::string& detail, const std::string& dev) {
  const std::string more = inBrackets(detail);
  switch (kind) {
    case CameraError::kAbsent:
      return "no camera at " + device + "; " + otherCameras(device, dev);
    case CameraError::kForbidden:
      return "no permission to open " + device + ": run `sudo usermod -aG video $USER`, then log out and in again";
    case CameraError::kBusy:
      return device + " is in use by another program: find it with `sudo fuser -v " + device + "` and stop it";
    case CameraError::kNotACamera:
      return device + " is not a capture device" + more + "; " + otherCameras(device, dev);
    case CameraError::kNoStreaming:
      return device + " does not support memory-mapped streaming" + more + "; use a camera with the uvcvideo driver";
    case CameraError::kOtherFormat:
      return device + " delivers " + detail + ", expected YUYV: choose a size for which `v4l2-ctl -d " + device +
             " --list-formats-ext` lists YUYV, or use another camera";
    case CameraError::kOtherSize:
      return device + " now delivers " + detail +
             "; the size cannot change while a controller runs: plug in the first camera again, or restart the "
             "controller";
    case CameraError::kFewBuffers:
      return device + " grants " + detail + ", two are needed: the kernel is short of memory, or the driver does not " +
             "support streaming; end other programs, or restart the robot";
    case CameraError::kNoBandwidth:
      return "not enough USB bandwidth for " + device +
             ": choose a smaller size, or unplug other cameras and sound devices";
    case CameraError::kUnplugged:
      return "camera at " + device + " unplugged" + more + ": check its USB cable";
    case CameraError::kSilent:
      return "no pictures from the camera at " + device + ": unplug it, plug it in again, and read `dmesg | tail`";
    case CameraError::kDamaged:
      return "only damaged pictures from the camera at " + device +
             ": check its USB cable, plug it in without a hub, or choose a smaller size";
    case CameraError::kReadErrors:
      return "cannot read pictures from " + device + more + ": check the USB cable and `dmesg | tail`";
    case CameraError::kOutOfMemory:
      return "out of memory for pictures of " + device + ": end other programs, or choose a smaller size";
    case CameraError::kOther:
    case CameraError::kCount:
      break;
  }
  return "cannot use " + device + " as a camera" + more + ": unplug it and plug it in again";
}

std::string explainReturn(const std::string& device) {
  return "the camera at " + device + " is back";
}

void refuse(const std::string& device, int error) {
  throw CameraRefused{cameraErrorOf(error), device, std::strerror(error)};
}

std::vector<std::string> videoDevices(const std::string& dev) {
  std::vector<std::string> devices;
  std::error_code error;
  for (std::filesystem::directory_iterator it{dev, error}, end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    constexpr std::size_t kPrefix = 5;
    if (name.size() > kPrefix && name.starts_with("video") &&
        name.find_first_not_of("0123456789", kPrefix) == std::string::npos)
      devices.push_back(it->path().string());
  }
  // video2 before video10: a shorter name has a smaller number.
  std::ranges::sort(devices, [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return devices;
}

}  // namespace darwinop::v4l2
