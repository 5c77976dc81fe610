// Virtual device: open, close, mmap, unplug.
#include "hil-mocks/camera/shim/device.hpp"

#include <fcntl.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>

namespace darwinop::hil::shim {

constinit FakeV4l2Device the_camera;

std::uint32_t FakeV4l2Device::handleOf(int fd) const {
  for (std::uint32_t i = 0; fd >= 0 && i < kMostHandles; ++i)
    if (fds_[i].load() == fd + 1) return i;
  return kNobody;
}

/// Lock-free: called for every file of the process.
bool FakeV4l2Device::owns(int fd) const {
  return handleOf(fd) != kNobody && process_.load() == getpid();
}

/// Holds the lock during fork(), so that no thread is inside.
void FakeV4l2Device::beforeFork() {
  pthread_mutex_lock(&the_camera.mutex_);
}

void FakeV4l2Device::afterForkInParent() {
  pthread_mutex_unlock(&the_camera.mutex_);
}

/// After fork() in the child: the thread and all descriptors belong to the parent.
void FakeV4l2Device::afterForkInChild() {
  the_camera.changed_ = PTHREAD_COND_INITIALIZER;  // otherwise it would wait for the parent's waiters
  for (std::uint32_t i = 0; i < kMostHandles; ++i) the_camera.fds_[i].store(0);
  the_camera.owner_ = kNobody;
  the_camera.streaming_ = false;
  the_camera.buffers_.release();
  pthread_mutex_unlock(&the_camera.mutex_);
}

int FakeV4l2Device::open(int flags) {
  const Lock lock{mutex_};
  if (!minds_forks_) minds_forks_ = pthread_atfork(beforeFork, afterForkInParent, afterForkInChild) == 0;
  reader_.refresh();
  const CameraFault fault = reader_.fault();
  std::uint32_t handle = 0;
  while (handle < kMostHandles && fds_[handle].load() != 0) ++handle;
  errno = fault == CameraFault::kGone       ? ENOENT
          : fault == CameraFault::kNoAccess ? EACCES
          : handle == kMostHandles          ? EMFILE
                                            : 0;
  if (errno != 0) return -1;
  const int fd = eventfd(
      0, EFD_SEMAPHORE | ((flags & O_NONBLOCK) != 0 ? EFD_NONBLOCK : 0) | ((flags & O_CLOEXEC) != 0 ? EFD_CLOEXEC : 0));
  if (fd < 0) return -1;
  process_.store(getpid());
  dead_[handle] = false;
  fds_[handle].store(fd + 1);
  return fd;
}

void FakeV4l2Device::closing(int fd) {
  const Lock lock{mutex_};
  const std::uint32_t handle = handleOf(fd);
  if (handle == kNobody) return;  // closed by another thread
  if (handle == owner_) {
    stop();
    buffers_.release();
    owner_ = kNobody;
  }
  fds_[handle].store(0);
}

int FakeV4l2Device::control(int fd, std::uint32_t request, void* argument) {
  if (argument == nullptr) return _IOC_SIZE(request) == 0 ? ENOTTY : EFAULT;
  const Lock lock{mutex_};
  const std::uint32_t handle = handleOf(fd);
  if (handle == kNobody) return EBADF;
  if (reader_.fault() == CameraFault::kGone) unplug();
  return dead_[handle] ? ENODEV : answer(handle, request, argument);
}

int FakeV4l2Device::memoryAt(std::size_t length, std::uint32_t offset) {
  constexpr std::size_t kPage = 4096;
  const Lock lock{mutex_};
  for (std::uint32_t i = 0; i < buffers_.count(); ++i) {
    if (buffers_.offset(i) != offset || (length + kPage - 1) / kPage != (buffers_.bytes() + kPage - 1) / kPage)
      continue;
    buffers_[i].mapped = true;
    return fcntl(buffers_.descriptor(), F_DUPFD_CLOEXEC, 0);
  }
  errno = EINVAL;
  return -1;
}

CameraFault FakeV4l2Device::fault() {
  const Lock lock{mutex_};
  reader_.refresh();
  return reader_.fault();
}

/// Notifies programs with the device open: readable descriptor, then ENODEV.
void FakeV4l2Device::unplug() {
  if (streaming_) stop();  // before the signals: it consumes pending ones
  for (std::uint32_t i = 0; i < kMostHandles; ++i) {
    const std::uint64_t one = 1;
    const int fd = fds_[i].load() - 1;
    if (fd >= 0 && !dead_[i]) [[maybe_unused]]
      const ssize_t written = write(fd, &one, sizeof one);
    dead_[i] = true;
  }
}

}  // namespace darwinop::hil::shim
