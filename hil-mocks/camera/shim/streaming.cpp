// Buffer ownership and streaming ioctls.
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "hil-mocks/camera/shim/device.hpp"

namespace darwinop::hil::shim {
namespace {

constexpr int kLookAgainMs = 50;  // polling interval of a blocked DQBUF for STREAMOFF

bool readable(int fd, int wait_ms) {
  pollfd one{fd, POLLIN, 0};
  return poll(&one, 1, wait_ms) == 1;
}

}  // namespace

int FakeV4l2Device::requestBuffers(std::uint32_t handle, v4l2_requestbuffers& request) {
  const CameraFault fault = reader_.fault();
  if (request.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || request.memory != V4L2_MEMORY_MMAP) return EINVAL;
  if (fault == CameraFault::kNoMmap) return EINVAL;
  if ((owner_ != kNobody && owner_ != handle) || streaming_) return EBUSY;
  buffers_.release();
  owner_ = kNobody;
  request.count = request.count > kMostBuffers ? kMostBuffers : request.count;
  if (fault == CameraFault::kOneBuffer && request.count > 1) request.count = 1;
  request.capabilities = V4L2_BUF_CAP_SUPPORTS_MMAP;
  request.flags = 0;
  if (request.count == 0) return 0;
  if (const int error = buffers_.allocate(request.count, kSizes[size_].bytes()); error != 0) return error;
  owner_ = handle;
  return 0;
}

void FakeV4l2Device::describe(std::uint32_t index, v4l2_buffer& buffer) {
  const Buffer& ours = buffers_[index];
  buffer = {};
  buffer.index = index;
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.field = V4L2_FIELD_NONE;
  buffer.length = buffers_.bytes();
  buffer.m.offset = buffers_.offset(index);
  buffer.bytesused = ours.bytes;
  buffer.sequence = ours.sequence;
  buffer.timestamp = ours.time;
  buffer.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | (ours.mapped ? V4L2_BUF_FLAG_MAPPED : 0u) |
                 (ours.damaged ? V4L2_BUF_FLAG_ERROR : 0u) |
                 (ours.state == Buffer::kQueued ? V4L2_BUF_FLAG_QUEUED : 0u) |
                 (ours.state == Buffer::kFilled ? V4L2_BUF_FLAG_DONE : 0u);
}

int FakeV4l2Device::queryBuffer(v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.index >= buffers_.count()) return EINVAL;
  describe(buffer.index, buffer);
  return 0;
}

int FakeV4l2Device::queue(std::uint32_t handle, v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.memory != V4L2_MEMORY_MMAP) return EINVAL;
  if ((buffer.flags & V4L2_BUF_FLAG_REQUEST_FD) != 0) return EINVAL;
  if (owner_ != kNobody && owner_ != handle) return EBUSY;
  if (buffer.index >= buffers_.count() || buffers_[buffer.index].state != Buffer::kWithProgram) return EINVAL;
  buffers_[buffer.index].state = Buffer::kQueued;
  buffers_[buffer.index].damaged = false;
  buffers_.queued.push(buffer.index);
  describe(buffer.index, buffer);
  return 0;
}

int FakeV4l2Device::dequeue(std::uint32_t handle, v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.memory != V4L2_MEMORY_MMAP) return EINVAL;
  if (owner_ != kNobody && owner_ != handle) return EBUSY;
  const int fd = fds_[handle].load() - 1;
  const bool waits = (fcntl(fd, F_GETFL) & O_NONBLOCK) == 0;
  const std::uint32_t generation = generation_;
  for (;;) {
    if (dead_[handle]) return ENODEV;
    if (!streaming_ || generation != generation_) return EINVAL;  // also after STREAMOFF during the wait
    if (!buffers_.filled.empty()) break;
    if (!waits) return EAGAIN;
    pthread_mutex_unlock(&mutex_);
    pollfd one{fd, POLLIN, 0};
    const int error = poll(&one, 1, kLookAgainMs) < 0 ? errno : 0;
    pthread_mutex_lock(&mutex_);
    if (error != 0) return error;
  }
  const std::uint32_t index = buffers_.filled.pop();
  takeSignal();
  if (reader_.fault() == CameraFault::kIoError) {  // the picture is lost, the buffer is not
    buffers_[index].state = Buffer::kQueued;
    buffers_.queued.push(index);
    return EIO;
  }
  buffers_[index].state = Buffer::kWithProgram;
  describe(index, buffer);
  return 0;
}

int FakeV4l2Device::streamOn(std::uint32_t handle, int type) {
  if (type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (owner_ == kNobody) return EINVAL;
  if (owner_ != handle || reader_.fault() == CameraFault::kBusy) return EBUSY;
  return streaming_ ? 0 : startThread();
}

int FakeV4l2Device::streamOff(std::uint32_t handle, int type) {
  if (type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (owner_ != kNobody && owner_ != handle) return EBUSY;
  stop();
  return 0;
}

void FakeV4l2Device::stop() {
  if (owner_ != kNobody)
    while (readable(ownerDescriptor(), 0)) takeSignal();
  streaming_ = false;
  ++generation_;
  pthread_cond_broadcast(&changed_);
  buffers_.takeBack();
}

/// Non-blocking: the program may have read the eventfd itself.
void FakeV4l2Device::takeSignal() {
  std::uint64_t one = 0;
  if (readable(ownerDescriptor(), 0)) [[maybe_unused]]
    const ssize_t taken = read(ownerDescriptor(), &one, sizeof one);
}

}  // namespace darwinop::hil::shim
