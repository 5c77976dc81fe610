#include "hal/shared_picture/reader.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "hal/descriptor.hpp"

namespace darwinop::shared_picture {
namespace {

constexpr Nanos kAskEvery{500'000'000};

/// Another user can put a link, a FIFO or a file of his own in place of both files.
bool isPlainFile(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1 &&
         (status.st_mode & S_IWOTH) == 0;
}

}  // namespace

CameraFrame Reader::newest() {
  const Nanos now = options_.now();
  if (now >= next_ask_) {
    next_ask_ = now + kAskEvery;
    attach(now);
    ask(now);
  }
  if (memory_.lost()) unmap();
  if (window_ == nullptr) return frame_;
  const std::uint32_t newest = window_->newest.load(std::memory_order_acquire);
  if (newest >= 1 && newest <= SharedWindow::kSlots && copy(window_->slots[newest - 1], now)) {
    shown_.swap(spare_);
    frame_.yuyv = shown_;
    ++frames_;
  }
  return frame_;
}

/// Copies to spare_ and frame_. Returns false if already known, too old, or overwritten during the copy.
bool Reader::copy(const Slot& slot, Nanos now) {
  const std::uint32_t turn = slot.turn.load(std::memory_order_acquire);
  if (turn % 2 != 0) return false;
  const std::uint64_t sequence = slot.sequence;
  const Nanos time{slot.time_ns};
  if (sequence == 0 || (sequence == frame_.sequence && time == frame_.time)) return false;
  if (now - time >= kFresh) return false;
  std::memcpy(spare_.data(), slot.bytes.data(), kPictureBytes);
  std::atomic_thread_fence(std::memory_order_acquire);
  if (slot.turn.load(std::memory_order_relaxed) != turn) return false;
  frame_ = {.sequence = sequence, .time = time, .width = kWidth, .height = kHeight};
  return true;
}

CameraHealth Reader::health() const {
  return {.seeing = frame_.sequence != 0 && options_.now() - frame_.time < kFresh, .frames = frames_};
}

/// The file may have been replaced by another process, or removed.
void Reader::attach(Nanos now) {
  const Descriptor file{::open(options_.files.pictures.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
  if (file.fd() < 0) {
    if (errno != ENOENT) log("cannot open " + options_.files.pictures + ": " + std::strerror(errno));
    unmap();
    return;
  }
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) return;
  if (window_ != nullptr && status.st_dev == device_ && status.st_ino == inode_) {
    if (const std::uint32_t other = window_->other_size.load(std::memory_order_relaxed); other != 0)
      log("camera pictures of the controller are " + std::to_string(other >> 16) + "x" +
          std::to_string(other & 0xFFFF) + ": observers need 320x240; set this size in the controller");
    else if (now - since_ >= 2 * kFresh && !health().seeing)
      log(kNoNewPictures + options_.files.pictures + ": the camera delivers none, or the controller was killed");
    return;
  }
  unmap();
  if (const std::string why = rejection(file.fd()); !why.empty()) {
    log("ignoring " + options_.files.pictures + ": " + why);
    return;
  }
  try {
    memory_ = GuardedMapping{file.fd(), sizeof(SharedWindow), PROT_READ};
  } catch (const std::system_error& error) {
    return log("cannot map " + options_.files.pictures + ": " + std::strerror(error.code().value()));
  }
  window_ = static_cast<const SharedWindow*>(memory_.data());
  device_ = status.st_dev;
  inode_ = status.st_ino;
  since_ = now;
}

/// read(), not mmap(): accessing a mapped file that is too short raises SIGBUS.
std::string Reader::rejection(int file) const {
  struct stat status {};
  if (::fstat(file, &status) != 0 || !isPlainFile(file)) return kNotAPlainFile;
  if (options_.group != static_cast<gid_t>(-1) && status.st_gid != options_.group)
    return "not owned by the runtime's group";
  std::uint32_t head[3] = {};
  const bool ours = status.st_size == static_cast<off_t>(sizeof(SharedWindow)) &&
                    ::pread(file, head, sizeof head, 0) == static_cast<ssize_t>(sizeof head) &&
                    head[0] == SharedWindow::kMagic && head[1] == SharedWindow::kLayout &&
                    head[2] == sizeof(SharedWindow);
  if (ours) return {};
  return std::string{kOtherVersion} + "; build the controller and darwinop monitor from the same version";
}

void Reader::ask(Nanos now) {
  if (window_ == nullptr) return;
  const Descriptor file{::open(options_.files.asked.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
  if (file.fd() >= 0 && !isPlainFile(file.fd())) return log("ignoring " + options_.files.asked + ": " + kNotAPlainFile);
  const std::int64_t stamp = now.count();
  if (file.fd() < 0 || ::pwrite(file.fd(), &stamp, sizeof stamp, 0) != static_cast<ssize_t>(sizeof stamp))
    log("cannot request pictures through " + options_.files.asked + ": " + std::strerror(errno));
}

void Reader::unmap() noexcept {
  memory_ = {};
  window_ = nullptr;
}

void Reader::log(const std::string& sentence) {
  if (options_.log && logged_.insert(sentence).second) options_.log(sentence);
}

}  // namespace darwinop::shared_picture
