// Thread that delivers one picture per interval.
#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include "hil-mocks/camera/shim/device.hpp"

namespace darwinop::hil::shim {
namespace {

constexpr std::size_t kStack = std::size_t{256} * 1024;  // small, since mlockall() of the program also locks it
constexpr long kSecondNs = 1'000'000'000;
constexpr double kSlowS = 0.2;                   // CameraFault::kSlow
constexpr std::uint32_t kFramesPerRefresh = 30;  // interval of checking for a new painter

timespec later(timespec time, double seconds) {
  const auto nanoseconds = time.tv_nsec + static_cast<long>(seconds * static_cast<double>(kSecondNs));
  return {time.tv_sec + nanoseconds / kSecondNs, nanoseconds % kSecondNs};
}

bool before(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec ? a.tv_sec < b.tv_sec : a.tv_nsec < b.tv_nsec;
}

timespec now() {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time;
}

}  // namespace

int FakeV4l2Device::startThread() {
  sigset_t all, mine;
  sigfillset(&all);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigdelset(&all, own);  // synchronous faults stay fatal
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);  // SCHED_OTHER even if the caller is real-time
  ++generation_;
  pthread_sigmask(SIG_BLOCK, &all, &mine);  // the program's signals must not be delivered to this thread
  pthread_t thread = {};
  // the argument is a number, passed as a pointer
  auto* const number = reinterpret_cast<void*>(std::uintptr_t{generation_});
  const int error = pthread_create(&thread, &attributes, runThread, number);
  pthread_sigmask(SIG_SETMASK, &mine, nullptr);
  pthread_attr_destroy(&attributes);
  if (error == 0) {
    streaming_ = true;
    sequence_ = 0;
  }
  return error;
}

void* FakeV4l2Device::runThread(void* generation) {
  the_camera.deliver(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(generation)));
  return nullptr;
}

void FakeV4l2Device::deliver(std::uint32_t generation) {
  const Lock lock{mutex_};
  timespec next = now();
  std::uint32_t frames = 0;
  while (generation == generation_) {
    const double slow = reader_.fault() == CameraFault::kSlow ? kSlowS : 0;
    const double period = seconds(interval_);
    next = later(next, period > slow ? period : slow);
    if (before(next, now())) next = now();  // the process was stopped
    while (generation == generation_ && before(now(), next))
      pthread_cond_clockwait(&changed_, &mutex_, CLOCK_MONOTONIC, &next);
    if (generation != generation_ || !frame()) return;
    if (++frames % kFramesPerRefresh == 0) reader_.refresh();
  }
}

bool FakeV4l2Device::frame() {
  const CameraFault fault = reader_.fault();
  if (fault == CameraFault::kGone) unplug();
  if (fault == CameraFault::kGone) return false;
  if (fault == CameraFault::kSilent) return true;
  const std::uint32_t sequence = sequence_++;
  if (fault == CameraFault::kDrops && sequence % 3 == 2) return true;
  if (buffers_.queued.empty()) return true;  // lost: the program is too slow
  const std::uint32_t index = buffers_.queued.pop();
  const FrameSize& size = kSizes[size_];
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

void FakeV4l2Device::signal() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(ownerDescriptor(), &one, sizeof one);
}

}  // namespace darwinop::hil::shim
