// Virtual device: owners, settings, and the delivery thread.
#pragma once

#include <linux/videodev2.h>
#include <pthread.h>
#include <sys/types.h>

#include <atomic>
#include <cstdint>

#include "hil-mocks/camera/shim/buffers.hpp"
#include "hil-mocks/camera/shim/controls.hpp"
#include "hil-mocks/camera/shim/frame_reader.hpp"
#include "hil-mocks/camera/shim/sizes.hpp"

namespace darwinop::hil::shim {

/// Each descriptor is an eventfd that is readable while a filled buffer waits, so that poll(), select() and epoll work
/// unchanged. A timerfd would also wake a program when the camera is silent.
///
/// Thread-safe. A child after fork() has no camera until it opens one. Never destroyed: other threads may still use it
/// at process exit.
class FakeV4l2Device {
 public:
  constexpr FakeV4l2Device() = default;

  int open(int flags);  // a descriptor, or -1 and errno
  [[nodiscard]] bool owns(int fd) const;
  void closing(int fd);
  int control(int fd, std::uint32_t request, void* argument);  // 0 or an errno
  /// Substitute for mmap() at this offset: a descriptor for the caller to close, or -1 and errno.
  int memoryAt(std::size_t length, std::uint32_t offset);
  [[nodiscard]] CameraFault fault();

 private:
  static constexpr std::uint32_t kMostHandles = 128;
  static constexpr std::uint32_t kNobody = kMostHandles;

  [[nodiscard]] std::uint32_t handleOf(int fd) const;
  [[nodiscard]] int ownerDescriptor() const { return fds_[owner_].load() - 1; }

  // asking.cpp: one query ioctl each
  int answer(std::uint32_t handle, std::uint32_t request, void* argument);
  int answerAboutControls(std::uint32_t request, void* argument);
  int capability(v4l2_capability& answer);
  int describeFormat(v4l2_fmtdesc& format);
  int describeSize(v4l2_frmsizeenum& size);
  int describeInterval(v4l2_frmivalenum& interval);
  int format(std::uint32_t request, v4l2_format& format);
  int parameters(std::uint32_t request, v4l2_streamparm& parameters);
  [[nodiscard]] std::uint32_t pixelFormat();

  // streaming.cpp
  int requestBuffers(std::uint32_t handle, v4l2_requestbuffers& request);
  int queryBuffer(v4l2_buffer& buffer);
  int queue(std::uint32_t handle, v4l2_buffer& buffer);
  int dequeue(std::uint32_t handle, v4l2_buffer& buffer);
  int streamOn(std::uint32_t handle, int type);
  int streamOff(std::uint32_t handle, int type);
  void stop();
  void describe(std::uint32_t index, v4l2_buffer& buffer);
  void takeSignal();

  // delivering.cpp
  int startThread();
  static void* runThread(void* generation);
  void deliver(std::uint32_t generation);
  bool frame();  // false: the camera is gone
  void signal();

  // device.cpp
  void unplug();
  static void beforeFork();
  static void afterForkInParent();
  static void afterForkInChild();

  pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;  // protects all but fds_ and process_
  pthread_cond_t changed_ = PTHREAD_COND_INITIALIZER;  // generation_
  std::atomic<int> fds_[kMostHandles + 1] = {};        // descriptor + 1; 0: free
  std::atomic<pid_t> process_{0};
  bool dead_[kMostHandles + 1] = {};  // unplugged while open: ENODEV until closed
  std::uint32_t owner_ = kNobody;     // owner of the buffers
  bool streaming_ = false;
  bool minds_forks_ = false;
  std::uint32_t generation_ = 0;  // thread generation; a new one ends the old thread
  std::uint32_t sequence_ = 0;
  std::uint32_t size_ = 0, priority_ = V4L2_PRIORITY_DEFAULT;
  v4l2_fract interval_ = kSizes[0].fastest;
  Controls controls_;
  Buffers buffers_;
  FrameFileReader reader_;
};

extern constinit FakeV4l2Device the_camera;

class Lock {
 public:
  explicit Lock(pthread_mutex_t& mutex) : mutex_{mutex} { pthread_mutex_lock(&mutex_); }
  ~Lock() { pthread_mutex_unlock(&mutex_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  pthread_mutex_t& mutex_;
};

}  // namespace darwinop::hil::shim
