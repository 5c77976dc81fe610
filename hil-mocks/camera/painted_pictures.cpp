#include "hil-mocks/camera/painted_pictures.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

namespace darwinop::hil {
namespace {

// A first read may find a picture left from earlier readers.
constexpr std::int64_t kFreshPaint = 2'000'000'000;  // ns

FrameFile* mapPaint(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  struct stat status {};
  void* memory = MAP_FAILED;
  if (fd >= 0 && ::fstat(fd, &status) == 0 && status.st_size == static_cast<off_t>(kFrameFileSize))
    memory = ::mmap(nullptr, kFrameFileSize, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (fd >= 0) ::close(fd);
  if (memory == MAP_FAILED) throw std::runtime_error("no painter has created " + path);
  auto* const file = static_cast<FrameFile*>(memory);
  if (file->magic == kFrameFileMagic && file->version == kFrameFileVersion) return file;
  ::munmap(memory, kFrameFileSize);
  throw std::runtime_error(path + " was created by another version");
}

}  // namespace

PaintedPictures::PaintedPictures(const std::string& path, bool set_size) : file_{mapPaint(path)} {
  if (!set_size) return;
  file_->wanted_width.store(kWidth);
  file_->wanted_height.store(kHeight);
}

PaintedPictures::~PaintedPictures() {
  ::munmap(file_, kFrameFileSize);
}

CameraFrame PaintedPictures::newest() {
  const std::int64_t now = frameFileClock();
  file_->glanced_ns.store(now);
  const std::uint32_t number = file_->pictures.load(std::memory_order_acquire), at = number % 2;
  if (number == 0 || number == frame_.sequence || file_->blind.load() != 0) return frame_;
  const std::int64_t painted = file_->painted_ns[at].load();
  if (file_->width[at].load() != kWidth || file_->height[at].load() != kHeight || now - painted >= kFreshPaint)
    return frame_;
  std::memcpy(spare_.data(), reinterpret_cast<const std::uint8_t*>(file_) + pictureAt(number), spare_.size());
  std::atomic_thread_fence(std::memory_order_acquire);
  if (file_->pictures.load(std::memory_order_relaxed) != number) return frame_;  // overwritten during the copy
  spare_.swap(shown_);
  frame_ = {.sequence = number, .time = Nanos{painted}, .width = kWidth, .height = kHeight, .yuyv = shown_};
  ++frames_;
  return frame_;
}

CameraHealth PaintedPictures::health() const {
  return {.seeing = frame_.sequence != 0 && frameFileClock() - frame_.time.count() < kFreshPaint, .frames = frames_};
}

std::string PaintedPictures::error() const {
  return file_->blind.load(std::memory_order_acquire) != 0 ? file_->why : "";
}

}  // namespace darwinop::hil
