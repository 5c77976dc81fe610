// The camera's buffers and its frames.
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include "hil-mocks/camera/shim/device.hpp"

namespace darwinop::hil::shim {
namespace {

constexpr std::size_t kStack = std::size_t{256} * 1024;  // a process that locks its memory locks this, too
constexpr long kSecond_ns = 1'000'000'000;
constexpr double kSlow_s = 0.2;                  // CameraFault::kSlow
constexpr int kLookAgain_ms = 50;                // while a program waits in DQBUF: did somebody switch off?
constexpr std::uint32_t kFramesPerRefresh = 30;  // then it looks for another painter

timespec later(timespec time, double seconds) {
  const auto nanoseconds = time.tv_nsec + static_cast<long>(seconds * static_cast<double>(kSecond_ns));
  return {time.tv_sec + nanoseconds / kSecond_ns, nanoseconds % kSecond_ns};
}

bool before(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec ? a.tv_sec < b.tv_sec : a.tv_nsec < b.tv_nsec;
}

timespec now() {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time;
}

bool readable(int fd, int wait_ms) {
  pollfd one{fd, POLLIN, 0};
  return poll(&one, 1, wait_ms) == 1;
}

}  // namespace

int Device::requestBuffers(std::uint32_t handle, v4l2_requestbuffers& request) {
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

void Device::describe(std::uint32_t index, v4l2_buffer& buffer) {
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

int Device::queryBuffer(v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.index >= buffers_.count()) return EINVAL;
  describe(buffer.index, buffer);
  return 0;
}

int Device::queue(std::uint32_t handle, v4l2_buffer& buffer) {
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

int Device::dequeue(std::uint32_t handle, v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.memory != V4L2_MEMORY_MMAP) return EINVAL;
  if (owner_ != kNobody && owner_ != handle) return EBUSY;
  const int fd = fds_[handle].load() - 1;
  const bool waits = (fcntl(fd, F_GETFL) & O_NONBLOCK) == 0;
  const std::uint32_t generation = generation_;
  for (;;) {
    if (dead_[handle]) return ENODEV;
    if (!streaming_ || generation != generation_) return EINVAL;  // also: switched off while we waited
    if (!buffers_.filled.empty()) break;
    if (!waits) return EAGAIN;
    pthread_mutex_unlock(&mutex_);
    pollfd one{fd, POLLIN, 0};
    const int error = poll(&one, 1, kLookAgain_ms) < 0 ? errno : 0;
    pthread_mutex_lock(&mutex_);
    if (error != 0) return error;
  }
  const std::uint32_t index = buffers_.filled.pop();
  takeSignal();
  if (reader_.fault() == CameraFault::kIoError) {  // the frame is lost, its buffer is not
    buffers_[index].state = Buffer::kQueued;
    buffers_.queued.push(index);
    return EIO;
  }
  buffers_[index].state = Buffer::kWithProgram;
  describe(index, buffer);
  return 0;
}

int Device::streamOn(std::uint32_t handle, int type) {
  if (type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (owner_ == kNobody) return EINVAL;
  if (owner_ != handle || reader_.fault() == CameraFault::kBusy) return EBUSY;
  return streaming_ ? 0 : startThread();
}

int Device::streamOff(std::uint32_t handle, int type) {
  if (type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (owner_ != kNobody && owner_ != handle) return EBUSY;
  stop();
  return 0;
}

void Device::stop() {
  if (owner_ != kNobody)
    while (readable(ownerDescriptor(), 0)) takeSignal();
  streaming_ = false;
  ++generation_;
  pthread_cond_broadcast(&changed_);
  buffers_.takeBack();
}

int Device::startThread() {
  sigset_t all, mine;
  sigfillset(&all);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);  // SCHED_OTHER, whoever switches it on
  ++generation_;
  pthread_sigmask(SIG_SETMASK, &all, &mine);  // no signal of the program's is for this thread
  pthread_t thread = {};
  const int error =
      pthread_create(&thread, &attributes, runThread, reinterpret_cast<void*>(std::uintptr_t{generation_}));
  pthread_sigmask(SIG_SETMASK, &mine, nullptr);
  pthread_attr_destroy(&attributes);
  if (error == 0) {
    streaming_ = true;
    sequence_ = 0;
  }
  return error;
}

void* Device::runThread(void* generation) {
  the_camera.deliver(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(generation)));
  return nullptr;
}

void Device::deliver(std::uint32_t generation) {
  const Lock lock{mutex_};
  timespec next = now();
  std::uint32_t frames = 0;
  while (generation == generation_) {
    const double slow = reader_.fault() == CameraFault::kSlow ? kSlow_s : 0;
    const double period = seconds(interval_);
    next = later(next, period > slow ? period : slow);
    if (before(next, now())) next = now();  // stopped for a while
    while (generation == generation_ && before(now(), next))
      pthread_cond_clockwait(&changed_, &mutex_, CLOCK_MONOTONIC, &next);
    if (generation != generation_ || !frame()) return;
    if (++frames % kFramesPerRefresh == 0) reader_.refresh();
  }
}

bool Device::frame() {
  const CameraFault fault = reader_.fault();
  if (fault == CameraFault::kGone) unplug();
  if (fault == CameraFault::kGone) return false;
  if (fault == CameraFault::kSilent) return true;
  const std::uint32_t sequence = sequence_++;
  if (fault == CameraFault::kDrops && sequence % 3 == 2) return true;
  if (buffers_.queued.empty()) return true;  // lost: the program was too slow
  const std::uint32_t index = buffers_.queued.pop();
  const Size& size = kSizes[size_];
  const timespec time = now();
  reader_.read(size.width, size.height, buffers_.data(index));
  Buffer& buffer = buffers_[index];
  buffer.bytes = fault == CameraFault::kShort ? size.bytes() / 2 : size.bytes();
  buffer.damaged = fault == CameraFault::kFlagged;
  buffer.sequence = sequence;
  buffer.time = {time.tv_sec, time.tv_nsec / 1000};
  buffer.state = Buffer::kFilled;
  buffers_.filled.push(index);
  signal();
  return true;
}

void Device::signal() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(ownerDescriptor(), &one, sizeof one);
}

/// Never waits: nothing is there when the program read its descriptor itself.
void Device::takeSignal() {
  std::uint64_t one = 0;
  if (readable(ownerDescriptor(), 0)) [[maybe_unused]]
    const ssize_t taken = read(ownerDescriptor(), &one, sizeof one);
}

}  // namespace darwinop::hil::shim
