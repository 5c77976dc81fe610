#include "hil-mocks/camera/frame_painter.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

#include "hal/pixels/bgra_to_yuyv.hpp"

namespace darwinop::hil {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error("cannot create the frame file " + path + ": " + std::strerror(error) +
                           "; choose a writable folder, for example --file /dev/shm/camera");
}

std::size_t yuyvBytes(PictureSize size) {
  return 2 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

void check(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

/// A frame file that an earlier painter left may be replaced; anything else is somebody's.
void requireReplaceable(const std::string& path) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0 && errno == ENOENT) return;
  std::uint32_t magic = 0;
  const bool is_ours = fd >= 0 && read(fd, &magic, sizeof magic) == sizeof magic && magic == kFrameFileMagic;
  if (fd >= 0) close(fd);
  if (!is_ours) throw std::runtime_error(path + kNotAFrameFile);
}

}  // namespace

FramePainter::FramePainter(std::string path) : path_{std::move(path)} {
  requireReplaceable(path_);
  // Created under another name and renamed: no reader maps a partial file, and a camera with the old one keeps it.
  std::string name = path_ + ".XXXXXX";
  const int fd = mkostemp(name.data(), O_CLOEXEC);
  if (fd < 0) fail(path_, errno);
  int error = ftruncate(fd, kFrameFileSize) == 0 ? 0 : errno;
  void* const memory =
      error == 0 ? mmap(nullptr, kFrameFileSize, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0) : MAP_FAILED;
  if (error == 0 && memory == MAP_FAILED) error = errno;
  struct stat status {};
  if (error == 0 && fstat(fd, &status) != 0) error = errno;
  device_ = status.st_dev;
  inode_ = status.st_ino;
  close(fd);
  if (error == 0) {
    file_ = new (memory) FrameFile;
    error = std::rename(name.c_str(), path_.c_str()) == 0 ? 0 : errno;
  }
  if (error == 0) return;
  if (memory != MAP_FAILED) munmap(memory, kFrameFileSize);
  unlink(name.c_str());
  fail(path_, error);
}

FramePainter::~FramePainter() {
  struct stat status {};  // detects replacement by another painter
  if (stat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == inode_) unlink(path_.c_str());
  munmap(file_, kFrameFileSize);
}

PictureSize FramePainter::wanted() const {
  const auto within = [](std::uint32_t value, int most) {
    return static_cast<int>(std::clamp(value, 2u, static_cast<std::uint32_t>(most)));
  };
  return {within(file_->wanted_width.load(), kMostWidth), within(file_->wanted_height.load(), kMostHeight)};
}

std::span<std::uint8_t> FramePainter::begin(PictureSize size) {
  check(size.width > 0 && size.height > 0 && size.width <= kMostWidth && size.height <= kMostHeight &&
            size.width % 2 == 0,
        "virtual camera pictures need an even width up to 800 and a height up to 600");
  const std::uint32_t next = file_->pictures.load() + 1;
  std::atomic_thread_fence(std::memory_order_seq_cst);  // orders `pictures` before the following writes
  file_->width[next % 2].store(static_cast<std::uint32_t>(size.width));
  file_->height[next % 2].store(static_cast<std::uint32_t>(size.height));
  return {reinterpret_cast<std::uint8_t*>(file_) + pictureAt(next), yuyvBytes(size)};
}

void FramePainter::complete() {
  file_->painted_ns[(file_->pictures.load() + 1) % 2].store(frameFileClock());
  file_->pictures.fetch_add(1, std::memory_order_release);
}

void FramePainter::paint(PictureSize size, std::span<const std::uint8_t> bgra) {
  check(bgra.size() == 2 * yuyvBytes(size), "BGRA pictures need four bytes per pixel");
  pixels::bgraToYuyvRotated(bgra, size.width, size.height, begin(size), 2 * static_cast<std::size_t>(size.width));
  complete();
}

void FramePainter::paintYuyv(PictureSize size, std::span<const std::uint8_t> yuyv) {
  check(yuyv.size() == yuyvBytes(size), "YUYV pictures need two bytes per pixel");
  std::ranges::copy(yuyv, begin(size).begin());
  complete();
}

int FramePainter::wantedRate() const {
  constexpr std::int64_t kPatience = 2'000'000'000;  // ns
  const std::int64_t now = frameFileClock(), asked = file_->asked_ns.load(), glanced = file_->glanced_ns.load();
  if (asked != 0 && now - asked < kPatience) return 30;
  return glanced != 0 && now - glanced < kPatience ? 15 : 0;
}

void FramePainter::giveUp(const std::string& why) {
  if (file_->blind.load() != 0) return;
  why.copy(file_->why, sizeof file_->why - 1);
  file_->blind.store(1, std::memory_order_release);
}

void FramePainter::setFault(CameraFault fault) {
  file_->fault.store(static_cast<std::uint32_t>(fault));
}

std::uint32_t FramePainter::painted() const {
  return file_->pictures.load();
}

}  // namespace darwinop::hil
