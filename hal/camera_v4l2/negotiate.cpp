// Cropping, format and rate of a V4L2 device.
#include "hal/camera_v4l2/negotiate.hpp"

#include <linux/videodev2.h>

#include <algorithm>

#include "core/camera_sizes.hpp"
#include "core/text/number_text.hpp"
#include "hal/camera_v4l2/camera_error.hpp"

namespace darwinop::v4l2 {
namespace {

/// Many drivers do not support cropping; their error is ignored.
void resetCropping(int fd) {
  v4l2_cropcap able{};
  able.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (request(fd, VIDIOC_CROPCAP, able) != 0) return;
  v4l2_crop crop{};
  crop.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  crop.c = able.defrect;
  static_cast<void>(request(fd, VIDIOC_S_CROP, crop));
}

/// The driver picks the nearest rate for this size. Drivers with a fixed rate lack this call or return 0.
void askForRate(const V4l2Device& device, Size size, const Remark& remark) {
  constexpr unsigned kPicturesPerSecond = 30;
  constexpr double kClearlySlower = 0.9;
  v4l2_streamparm rate{};
  rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  rate.parm.capture.timeperframe = {1, kPicturesPerSecond};
  if (request(device.fd(), VIDIOC_S_PARM, rate) != 0) return;
  const v4l2_fract& interval = rate.parm.capture.timeperframe;
  if (interval.numerator == 0 || interval.denominator == 0) return;
  const double granted = static_cast<double>(interval.denominator) / static_cast<double>(interval.numerator);
  const CameraSize* const usual = cameraSize(size.width, size.height);
  if (usual != nullptr && granted < kClearlySlower * usual->rate_hz)
    remark(device.path() + " delivers " + text::fixedText(granted, 1) + " pictures/s at " + text(size) +
           ", the robot's own camera " + text::fixedText(usual->rate_hz, 1) +
           "; find a faster size with `v4l2-ctl -d " + device.path() + " --list-formats-ext`");
}

/// The fourcc as text, such as "MJPG".
std::string lettersOf(std::uint32_t code) {
  std::string letters;
  for (int shift = 0; shift < 32; shift += 8) {
    const char letter = static_cast<char>((code >> shift) & 0x7F);
    letters += letter > ' ' ? letter : '?';
  }
  return letters;
}

PictureShape shapeOf(const v4l2_pix_format& given) {
  // Some drivers leave bytesperline 0.
  return {{static_cast<int>(given.width), static_cast<int>(given.height)},
          std::max<std::size_t>(given.bytesperline, 2u * given.width)};
}

PictureShape askFor(const V4l2Device& device, Size wanted) {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_pix_format& pixels = format.fmt.pix;
  pixels.width = static_cast<std::uint32_t>(wanted.width);
  pixels.height = static_cast<std::uint32_t>(wanted.height);
  pixels.pixelformat = V4L2_PIX_FMT_YUYV;
  pixels.field = V4L2_FIELD_INTERLACED;
  if (const int error = request(device.fd(), VIDIOC_S_FMT, format); error != 0) {
    // VIDIOC_QUERYCAP worked, so EINVAL refers to the format.
    if (error == EINVAL) throw CameraRefused{CameraError::kOtherFormat, device.path(), "another format than YUYV"};
    refuse(device.path(), error);
  }
  if (pixels.pixelformat != V4L2_PIX_FMT_YUYV)
    throw CameraRefused{CameraError::kOtherFormat, device.path(), lettersOf(pixels.pixelformat)};
  // YUYV stores pixels in pairs. The limit keeps products within 32 bits.
  constexpr std::uint32_t kMost = 8192, kMostBytesPerRow = 65536;
  if (pixels.width < 2 || pixels.width % 2 != 0 || pixels.width > kMost || pixels.height < 1 || pixels.height > kMost ||
      pixels.bytesperline > kMostBytesPerRow)
    throw CameraRefused{CameraError::kOtherFormat, device.path(),
                        std::to_string(pixels.width) + "x" + std::to_string(pixels.height) + " pixels of YUYV"};
  return shapeOf(pixels);
}

}  // namespace

std::string text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

PictureShape negotiate(const V4l2Device& device, Size wanted, const Remark& remark) {
  resetCropping(device.fd());
  PictureShape given = askFor(device, wanted);
  if (given.size != wanted) {
    if (given.size != kFallback) given = askFor(device, kFallback);
    remark(device.path() + " does not support " + text(wanted) + ": using " + text(given.size) + "; see `v4l2-ctl -d " +
           device.path() + " --list-formats-ext`");
  }
  askForRate(device, given.size, remark);
  return given;
}

}  // namespace darwinop::v4l2
