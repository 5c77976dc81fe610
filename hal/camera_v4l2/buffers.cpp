// Memory-mapped V4L2 streaming buffers.
#include "hal/camera_v4l2/buffers.hpp"

#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <string>

#include "hal/camera_v4l2/camera_error.hpp"
#include "hal/camera_v4l2/monotonic.hpp"

namespace darwinop::v4l2 {
namespace {

// With 64-bit times on a 32-bit CPU, VIDIOC_DQBUF has another request number, which Linux 2.6.31 does not support.
static_assert(sizeof(timeval) == 2 * sizeof(long));

v4l2_buffer bufferNumber(std::uint32_t index) noexcept {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

/// Old drivers use the time of day, which may jump, and some mark it as monotonic (uvcvideo with clock=CLOCK_REALTIME);
/// a time that is not monotonic or in the future is replaced by the present one.
std::chrono::nanoseconds timeOf(const v4l2_buffer& buffer) noexcept {
  const std::chrono::nanoseconds now = monotonicNow();
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) return now;
  return std::min(now, std::chrono::nanoseconds{std::chrono::seconds{buffer.timestamp.tv_sec} +
                                                std::chrono::microseconds{buffer.timestamp.tv_usec}});
}

std::uint32_t grantedBuffers(const V4l2Device& device) {
  v4l2_requestbuffers wanted{};
  wanted.count = StreamBuffers::kAsked;
  wanted.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  wanted.memory = V4L2_MEMORY_MMAP;
  const int error = request(device.fd(), VIDIOC_REQBUFS, wanted);
  if (error == EINVAL) throw CameraRefused{CameraError::kNoStreaming, device.path()};
  if (error != 0) refuse(device.path(), error);
  if (wanted.count < StreamBuffers::kNeeded)
    throw CameraRefused{CameraError::kFewBuffers, device.path(),
                        wanted.count == 0 ? StreamBuffers::kNoBuffer : StreamBuffers::kOneBuffer};
  return wanted.count;
}

}  // namespace

StreamBuffers::StreamBuffers(const V4l2Device& device) : device_{device} {
  try {
    map();
    for (std::uint32_t i = 0; i < count(); ++i)
      if (const int error = giveBack(i); error != 0) refuse(device_.path(), error);
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (const int error = request(device_.fd(), VIDIOC_STREAMON, type); error != 0) refuse(device_.path(), error);
  } catch (...) {
    release();
    throw;
  }
}

StreamBuffers::~StreamBuffers() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  static_cast<void>(request(device_.fd(), VIDIOC_STREAMOFF, type));
  release();
}

void StreamBuffers::map() {
  const std::uint32_t granted = grantedBuffers(device_);
  mapped_.reserve(granted);
  for (std::uint32_t i = 0; i < granted; ++i) {
    v4l2_buffer buffer = bufferNumber(i);
    if (const int error = request(device_.fd(), VIDIOC_QUERYBUF, buffer); error != 0) refuse(device_.path(), error);
    void* memory = ::mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, device_.fd(),
                          static_cast<off_t>(buffer.m.offset));
    if (memory == MAP_FAILED) refuse(device_.path(), errno);
    mapped_.emplace_back(static_cast<std::uint8_t*>(memory), buffer.length);
  }
}

void StreamBuffers::release() noexcept {
  for (const auto memory : mapped_) ::munmap(memory.data(), memory.size());
  mapped_.clear();
}

Filled StreamBuffers::take() noexcept {
  v4l2_buffer buffer = bufferNumber(0);
  Filled filled;
  filled.error = request(device_.fd(), VIDIOC_DQBUF, buffer);
  if (filled.error != 0) return filled;
  if (buffer.index >= count()) {
    filled.error = EPROTO;  // the driver returned a buffer that was not queued
    return filled;
  }
  filled.index = buffer.index;
  filled.sequence = buffer.sequence;
  filled.marked_bad = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
  filled.time = timeOf(buffer);
  const auto memory = mapped_[buffer.index];
  filled.bytes = memory.first(std::min<std::size_t>(buffer.bytesused, memory.size()));
  return filled;
}

int StreamBuffers::giveBack(std::uint32_t index) noexcept {
  v4l2_buffer buffer = bufferNumber(index);
  return request(device_.fd(), VIDIOC_QBUF, buffer);
}

int StreamBuffers::giveBackStrays() noexcept {
  constexpr std::uint32_t kDrivers = V4L2_BUF_FLAG_QUEUED | V4L2_BUF_FLAG_DONE;
  for (std::uint32_t i = 0; i < count(); ++i) {
    v4l2_buffer buffer = bufferNumber(i);
    int error = request(device_.fd(), VIDIOC_QUERYBUF, buffer);
    if (error == 0 && (buffer.flags & kDrivers) == 0) error = giveBack(i);
    if (error != 0) return error;
  }
  return 0;
}

}  // namespace darwinop::v4l2
