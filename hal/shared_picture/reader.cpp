#include "hal/shared_picture/reader.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace darwinop::shared_picture {
namespace {

constexpr Nanos kAskEvery{500'000'000};

struct WindowFile {
  int fd;
  ~WindowFile() {
    if (fd >= 0) ::close(fd);
  }
};

}  // namespace

CameraFrame Reader::newest() {
  const Nanos now = options_.now();
  if (now >= next_ask_) {
    next_ask_ = now + kAskEvery;
    attach(now);
    ask(now);
  }
  if (memory_.lost()) letGo();
  if (window_ == nullptr) return frame_;
  const std::uint32_t newest = window_->newest.load(std::memory_order_acquire);
  if (newest >= 1 && newest <= Window::kSlots && copy(window_->slots[newest - 1], now)) {
    shown_.swap(spare_);
    frame_.yuyv = shown_;
    ++frames_;
  }
  return frame_;
}

/// Into spare_ and frame_; false: it is known, old, or was overwritten meanwhile.
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

/// Another process' window may have taken the place of the one that is mapped, or there is none any more.
void Reader::attach(Nanos now) {
  const WindowFile file{::open(options_.files.pictures.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
  if (file.fd < 0) {
    if (errno != ENOENT) tell("cannot open " + options_.files.pictures + ": " + std::strerror(errno));
    letGo();
    return;
  }
  struct stat status {};
  if (::fstat(file.fd, &status) != 0) return;
  if (window_ != nullptr && status.st_dev == device_ && status.st_ino == inode_) {
    if (const std::uint32_t other = window_->other_size.load(std::memory_order_relaxed); other != 0)
      tell("the pictures of the controller's camera are " + std::to_string(other >> 16) + "x" +
           std::to_string(other & 0xFFFF) + ": onlookers are shown those of 320x240 only");
    else if (now - since_ >= 2 * kFresh && !health().seeing)
      tell("there are no new pictures in " + options_.files.pictures +
           ": the camera gives none, or the controller that showed them was killed");
    return;
  }
  letGo();
  if (const std::string why = whyNot(file.fd); !why.empty()) {
    tell(options_.files.pictures + " is not looked at: " + why);
    return;
  }
  try {
    memory_ = GuardedMapping{file.fd, sizeof(Window), PROT_READ};
  } catch (const std::system_error& error) {
    return tell("cannot map " + options_.files.pictures + ": " + std::strerror(error.code().value()));
  }
  window_ = static_cast<const Window*>(memory_.data());
  device_ = status.st_dev;
  inode_ = status.st_ino;
  since_ = now;
}

/// Read, not mapped: a file that is too short would kill its reader.
std::string Reader::whyNot(int file) const {
  struct stat status {};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return "it is no file";
  if (options_.group != static_cast<gid_t>(-1) && status.st_gid != options_.group)
    return "it does not belong to the runtime's group";
  std::uint32_t head[3] = {};
  const bool ours = status.st_size == static_cast<off_t>(sizeof(Window)) &&
                    ::pread(file, head, sizeof head, 0) == static_cast<ssize_t>(sizeof head) &&
                    head[0] == Window::kMagic && head[1] == Window::kLayout && head[2] == sizeof(Window);
  return ours ? "" : "another version made it; build the controller and darwinop monitor from the same version";
}

void Reader::ask(Nanos now) {
  if (window_ == nullptr) return;
  const WindowFile file{::open(options_.files.asked.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
  const std::int64_t stamp = now.count();
  if (file.fd < 0 || ::pwrite(file.fd, &stamp, sizeof stamp, 0) != static_cast<ssize_t>(sizeof stamp))
    tell("cannot ask for pictures in " + options_.files.asked + ": " + std::strerror(errno));
}

void Reader::letGo() noexcept {
  memory_ = {};
  window_ = nullptr;
}

void Reader::tell(const std::string& sentence) {
  if (options_.say && told_.insert(sentence).second) options_.say(sentence);
}

}  // namespace darwinop::shared_picture
