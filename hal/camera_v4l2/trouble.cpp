// Words for a camera that does not do what a camera should.
#include "hal/camera_v4l2/trouble.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace darwinop::v4l2 {
namespace {

constexpr const char* kList = "`v4l2-ctl --list-devices` tells which is which";

std::string otherCameras(const std::string& device, const std::string& dev) {
  std::vector<std::string> others = videoDevices(dev);
  std::erase(others, device);
  if (others.empty())
    return "no other video device is there either: check the camera's USB cable, `lsusb` must show it";
  std::string text = "video devices that are there:";
  for (const std::string& other : others) text += " " + other;
  return text + "; " + kList;
}

std::string inBrackets(const std::string& detail) {
  return detail.empty() ? std::string{} : " (" + detail + ")";
}

}  // namespace

Trouble troubleOf(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case ENODEV:
    case ENXIO:
      return Trouble::kAbsent;
    case EACCES:
    case EPERM:
      return Trouble::kForbidden;
    case EBUSY:
      return Trouble::kBusy;
    case ENOTTY:
    case EISDIR:
    case ELOOP:
      return Trouble::kNotACamera;
    case ENOSPC:
      return Trouble::kNoBandwidth;
    case ENOMEM:
      return Trouble::kOutOfMemory;
    case EIO:
    case EPROTO:
      return Trouble::kReadErrors;
    default:
      return Trouble::kOther;
  }
}

std::string explain(Trouble trouble, const std::string& device, const std::string& detail, const std::string& dev) {
  const std::string more = inBrackets(detail);
  switch (trouble) {
    case Trouble::kAbsent:
      return "there is no camera at " + device + "; " + otherCameras(device, dev);
    case Trouble::kForbidden:
      return "no permission to open " + device + ": run `sudo usermod -aG video $USER`, then log out and in again";
    case Trouble::kBusy:
      return device + " is in use by another program: find it with `sudo fuser -v " + device + "` and stop it";
    case Trouble::kNotACamera:
      return device + " is not a camera that takes pictures" + more + "; " + otherCameras(device, dev);
    case Trouble::kNoStreaming:
      return device + " cannot hand over pictures in mapped memory" + more +
             ": a camera with the kernel's driver uvcvideo is needed";
    case Trouble::kOtherFormat:
      return device + " gives pictures as " + detail +
             ", only YUYV can be used: choose a size for which `v4l2-ctl -d " + device +
             " --list-formats-ext` shows YUYV, or another camera";
    case Trouble::kOtherSize:
      return device + " now gives pictures of " + detail +
             ": a controller cannot change size while it runs; plug the first camera in again, or restart the "
             "controller";
    case Trouble::kFewBuffers:
      return device + " grants " + detail + ", two are needed: memory of the kernel is short, or the driver is not " +
             "for streaming; end other programs, or restart the robot";
    case Trouble::kNoBandwidth:
      return "the USB bus has no room for the pictures of " + device +
             ": choose a smaller size, or unplug other cameras and sound devices";
    case Trouble::kUnplugged:
      return "the camera at " + device + " is gone" + more + ": check its USB cable";
    case Trouble::kSilent:
      return "the camera at " + device +
             " sends no pictures: unplug it and plug it in again, `dmesg | tail` tells what the kernel saw";
    case Trouble::kDamaged:
      return "the camera at " + device +
             " sends only damaged pictures: check its USB cable, plug it in without a hub, or choose a smaller size";
    case Trouble::kReadErrors:
      return "the pictures of " + device + " cannot be read" + more +
             ": check the USB cable, `dmesg | tail` tells what the kernel saw";
    case Trouble::kOutOfMemory:
      return "no memory for the pictures of " + device + ": end other programs, or choose a smaller size";
    case Trouble::kOther:
    case Trouble::kCount:
      break;
  }
  return device + " cannot be used as a camera" + more + ": unplug it and plug it in again";
}

void refuse(const std::string& device, int error) {
  throw CameraRefused{troubleOf(error), device, std::strerror(error)};
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
  // video2 before video10: a shorter name is a smaller number.
  std::ranges::sort(devices, [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return devices;
}

}  // namespace darwinop::v4l2
