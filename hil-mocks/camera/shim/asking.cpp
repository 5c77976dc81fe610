// V4L2 query ioctls.
#include <errno.h>
#include <linux/videodev2.h>

#include <cstdio>

#include "hil-mocks/camera/shim/device.hpp"

namespace darwinop::hil::shim {
namespace {

constexpr std::uint32_t kDriverVersion = 0x00060100;  // 6.1, Debian 12's

template <std::size_t N>
void copyText(std::uint8_t (&to)[N], const char* text) {
  std::snprintf(reinterpret_cast<char*>(to), N, "%s", text);
}

template <class T>
T& as(void* argument) {
  return *static_cast<T*>(argument);
}

const FrameSize* sizeOf(std::uint32_t width, std::uint32_t height) {
  for (const FrameSize& size : kSizes)
    if (size.width == width && size.height == height) return &size;
  return nullptr;
}

int describeInput(v4l2_input& input) {
  if (input.index != 0) return EINVAL;
  input = {};
  copyText(input.name, "Camera 1");
  input.type = V4L2_INPUT_TYPE_CAMERA;
  return 0;
}

}  // namespace

std::uint32_t FakeV4l2Device::pixelFormat() {
  return reader_.fault() == CameraFault::kOtherFormat ? V4L2_PIX_FMT_MJPEG : V4L2_PIX_FMT_YUYV;
}

int FakeV4l2Device::capability(v4l2_capability& answer) {
  answer = {};
  copyText(answer.driver, "darwinop");
  copyText(answer.card, "DARwIn-OP virtual camera");
  copyText(answer.bus_info, "platform:darwinop-camera");
  answer.version = kDriverVersion;
  answer.device_caps = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_EXT_PIX_FORMAT |
                       (reader_.fault() == CameraFault::kNoMmap ? 0u : V4L2_CAP_STREAMING);
  answer.capabilities = answer.device_caps | V4L2_CAP_DEVICE_CAPS;
  return 0;
}

int FakeV4l2Device::describeFormat(v4l2_fmtdesc& format) {
  if (format.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || format.index != 0) return EINVAL;
  format = {};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.pixelformat = pixelFormat();
  const bool plain = format.pixelformat == V4L2_PIX_FMT_YUYV;
  format.flags = plain ? 0 : V4L2_FMT_FLAG_COMPRESSED;
  copyText(format.description, plain ? "YUYV 4:2:2" : "Motion-JPEG");
  return 0;
}

int FakeV4l2Device::describeSize(v4l2_frmsizeenum& size) {
  if (size.pixel_format != pixelFormat() || size.index >= kSizeCount) return EINVAL;
  const std::uint32_t index = size.index, format = size.pixel_format;
  size = {};
  size.index = index;
  size.pixel_format = format;
  size.type = V4L2_FRMSIZE_TYPE_DISCRETE;
  size.discrete = {kSizes[index].width, kSizes[index].height};
  return 0;
}

int FakeV4l2Device::describeInterval(v4l2_frmivalenum& asked) {
  const FrameSize* const size = sizeOf(asked.width, asked.height);
  if (size == nullptr || asked.pixel_format != pixelFormat() || asked.index >= kIntervalCount) return EINVAL;
  asked.type = V4L2_FRMIVAL_TYPE_DISCRETE;
  asked.discrete = interval(*size, asked.index);
  asked.reserved[0] = asked.reserved[1] = 0;
  return 0;
}

int FakeV4l2Device::format(std::uint32_t request, v4l2_format& format) {
  if (format.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  const bool sets = request == VIDIOC_S_FMT;
  if (sets && (buffers_.count() != 0 || reader_.fault() == CameraFault::kBusy)) return EBUSY;
  const std::uint32_t index =
      request == VIDIOC_G_FMT ? size_ : nearestSize(format.fmt.pix.width, format.fmt.pix.height);
  const FrameSize& size = kSizes[index];
  if (sets) {
    size_ = index;
    interval_ = size.fastest;
    reader_.want(size.width, size.height);
  }
  format = {};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_pix_format& pixels = format.fmt.pix;
  pixels.width = size.width;
  pixels.height = size.height;
  pixels.pixelformat = pixelFormat();
  pixels.field = V4L2_FIELD_NONE;
  pixels.bytesperline = pixels.pixelformat == V4L2_PIX_FMT_YUYV ? 2 * size.width : 0;
  pixels.sizeimage = size.bytes();
  pixels.colorspace = V4L2_COLORSPACE_SRGB;
  return 0;
}

int FakeV4l2Device::parameters(std::uint32_t request, v4l2_streamparm& parameters) {
  if (parameters.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (request == VIDIOC_S_PARM) {
    if (streaming_) return EBUSY;
    interval_ = nearestInterval(kSizes[size_], parameters.parm.capture.timeperframe);
  }
  parameters = {};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  parameters.parm.capture.capability = V4L2_CAP_TIMEPERFRAME;
  parameters.parm.capture.timeperframe = interval_;
  return 0;
}

int FakeV4l2Device::answerAboutControls(std::uint32_t request, void* argument) {
  switch (request) {
    case VIDIOC_QUERYCTRL:
      return controls_.describe(as<v4l2_queryctrl>(argument));
    case VIDIOC_QUERY_EXT_CTRL:
      return controls_.describe(as<v4l2_query_ext_ctrl>(argument));
    case VIDIOC_QUERYMENU:
      return Controls::describe(as<v4l2_querymenu>(argument));
    case VIDIOC_G_CTRL:
      return controls_.get(as<v4l2_control>(argument).id, as<v4l2_control>(argument).value);
    case VIDIOC_S_CTRL:
      return controls_.set(as<v4l2_control>(argument).id, as<v4l2_control>(argument).value);
    case VIDIOC_G_EXT_CTRLS:
      return controls_.get(as<v4l2_ext_controls>(argument));
    case VIDIOC_S_EXT_CTRLS:
      return controls_.set(as<v4l2_ext_controls>(argument), false);
    case VIDIOC_TRY_EXT_CTRLS:
      return controls_.set(as<v4l2_ext_controls>(argument), true);
    default:
      return ENOTTY;  // unsupported, such as cropping
  }
}

int FakeV4l2Device::answer(std::uint32_t handle, std::uint32_t request, void* argument) {
  switch (request) {
    case VIDIOC_QUERYCAP:
      return capability(as<v4l2_capability>(argument));
    case VIDIOC_ENUMINPUT:
      return describeInput(as<v4l2_input>(argument));
    case VIDIOC_G_INPUT:
      as<int>(argument) = 0;
      return 0;
    case VIDIOC_S_INPUT:
      return as<int>(argument) == 0 ? 0 : EINVAL;
    case VIDIOC_ENUM_FMT:
      return describeFormat(as<v4l2_fmtdesc>(argument));
    case VIDIOC_ENUM_FRAMESIZES:
      return describeSize(as<v4l2_frmsizeenum>(argument));
    case VIDIOC_ENUM_FRAMEINTERVALS:
      return describeInterval(as<v4l2_frmivalenum>(argument));
    case VIDIOC_G_FMT:
    case VIDIOC_TRY_FMT:
    case VIDIOC_S_FMT:
      return format(request, as<v4l2_format>(argument));
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      return parameters(request, as<v4l2_streamparm>(argument));
    case VIDIOC_G_PRIORITY:
      as<std::uint32_t>(argument) = priority_;
      return 0;
    case VIDIOC_S_PRIORITY:
      if (as<std::uint32_t>(argument) > V4L2_PRIORITY_RECORD) return EINVAL;
      priority_ = as<std::uint32_t>(argument);
      return 0;
    case VIDIOC_REQBUFS:
      return requestBuffers(handle, as<v4l2_requestbuffers>(argument));
    case VIDIOC_QUERYBUF:
      return queryBuffer(as<v4l2_buffer>(argument));
    case VIDIOC_QBUF:
      return queue(handle, as<v4l2_buffer>(argument));
    case VIDIOC_DQBUF:
      return dequeue(handle, as<v4l2_buffer>(argument));
    case VIDIOC_STREAMON:
      return streamOn(handle, as<int>(argument));
    case VIDIOC_STREAMOFF:
      return streamOff(handle, as<int>(argument));
    default:
      return answerAboutControls(request, argument);
  }
}

}  // namespace darwinop::hil::shim
