// Buffers mapped by a program; one anonymous file for all.
#include "hil-mocks/camera/shim/buffers.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace darwinop::hil::shim {
namespace {

constexpr std::uint32_t kPage = 4096;

}  // namespace

std::uint32_t Line::pop() {
  const std::uint32_t first = index_[0];
  --count_;
  std::memmove(index_, index_ + 1, count_ * sizeof index_[0]);
  return first;
}

int Buffers::allocate(std::uint32_t count, std::uint32_t bytes_each) {
  release();
  const std::uint32_t stride = (bytes_each + kPage - 1) / kPage * kPage;
  const std::size_t all = std::size_t{count} * stride;
  const int fd = memfd_create("darwinop-virtual-camera", MFD_CLOEXEC);
  if (fd < 0) return errno;
  void* const memory = ftruncate(fd, static_cast<off_t>(all)) == 0
                           ? mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0)
                           : MAP_FAILED;
  if (memory == MAP_FAILED) {
    close(fd);
    return ENOMEM;
  }
  fd_ = fd;
  memory_ = static_cast<std::uint8_t*>(memory);
  count_ = count;
  bytes_ = bytes_each;
  stride_ = stride;
  return 0;
}

void Buffers::release() {
  takeBack();
  for (Buffer& buffer : buffer_) buffer = Buffer{};
  if (fd_ < 0) return;
  munmap(memory_, std::size_t{count_} * stride_);
  close(fd_);
  fd_ = -1;
  memory_ = nullptr;
  count_ = 0;
}

void Buffers::takeBack() {
  queued.clear();
  filled.clear();
  for (Buffer& buffer : buffer_) buffer.state = Buffer::kWithProgram;
}

}  // namespace darwinop::hil::shim
