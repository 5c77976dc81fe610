// Reader of the frame file.
#include "hil-mocks/camera/shim/frame_reader.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace darwinop::hil::shim {
namespace {

constexpr int kTries = 10;  // each fails only if a picture is completed during the copy of 0.1 ms
constexpr std::uint8_t kGrey = 128;

/// nullptr: not a frame file of this version, or not writable.
FrameFile* mapped(int fd, const struct stat& status) {
  if (status.st_size < static_cast<off_t>(kFrameFileSize)) return nullptr;
  void* const memory = mmap(nullptr, kFrameFileSize, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (memory == MAP_FAILED) return nullptr;
  auto* const file = static_cast<FrameFile*>(memory);
  if (file->magic == kFrameFileMagic && file->version == kFrameFileVersion) return file;
  munmap(memory, kFrameFileSize);
  return nullptr;
}

}  // namespace

void FrameFileReader::refresh() {
  const char* const path = std::getenv("DARWINOP_VIRTUAL_CAMERA");
  if (path == nullptr) return;
  const int fd = open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
  struct stat status = {};
  if (fd >= 0 && fstat(fd, &status) == 0 && S_ISREG(status.st_mode) &&
      (file_ == nullptr || status.st_dev != device_ || status.st_ino != inode_)) {
    if (FrameFile* const file = mapped(fd, status); file != nullptr) {
      if (file_ != nullptr) munmap(file_, kFrameFileSize);
      file_ = file;
      device_ = status.st_dev;
      inode_ = status.st_ino;
      want(width_, height_);
    }
  }
  if (fd >= 0) close(fd);
}

CameraFault FrameFileReader::fault() const {
  return file_ == nullptr ? CameraFault::kNone : static_cast<CameraFault>(file_->fault.load());
}

void FrameFileReader::want(std::uint32_t width, std::uint32_t height) {
  width_ = width;
  height_ = height;
  if (file_ == nullptr) return;
  file_->wanted_width.store(width);
  file_->wanted_height.store(height);
  ask();
}

void FrameFileReader::ask() const {
  if (file_ != nullptr) file_->asked_ns.store(frameFileClock());
}

void FrameFileReader::read(std::uint32_t width, std::uint32_t height, std::uint8_t* yuyv) const {
  const std::size_t bytes = std::size_t{2} * width * height;
  ask();
  for (int i = 0; file_ != nullptr && i < kTries; ++i) {
    const std::uint32_t number = file_->pictures.load(std::memory_order_acquire);
    if (number == 0 || file_->width[number % 2].load() != width || file_->height[number % 2].load() != height) break;
    std::memcpy(yuyv, reinterpret_cast<const std::uint8_t*>(file_) + pictureAt(number), bytes);
    std::atomic_thread_fence(std::memory_order_acquire);
    if (file_->pictures.load(std::memory_order_relaxed) == number) return;
  }
  std::memset(yuyv, kGrey, bytes);
}

}  // namespace darwinop::hil::shim
