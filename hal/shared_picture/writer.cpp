#include "hal/shared_picture/writer.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace darwinop::shared_picture {
namespace {

[[noreturn]] void failWindow(const std::string& what, int error, const std::string& remedy) {
  throw std::runtime_error(what + ": " + std::strerror(error) + "; " + remedy);
}

/// Creates a temporary file beside `path` at full length: a full disk is an error here instead of SIGBUS later.
int makeFresh(const std::string& fresh, mode_t mode, gid_t group, std::size_t size) {
  ::unlink(fresh.c_str());
  const int file = ::open(fresh.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
  if (file < 0) failWindow("cannot create " + fresh, errno, "check that the folder exists and is writable");
  int error = ::fchmod(file, mode) != 0 || ::fchown(file, static_cast<uid_t>(-1), group) != 0 ? errno : 0;
  const bool given = error == 0;
  if (given) error = ::posix_fallocate(file, 0, static_cast<off_t>(size));
  if (error == 0) return file;
  ::close(file);
  ::unlink(fresh.c_str());
  if (!given) failWindow("cannot give " + fresh + " to the runtime's group", error, "add this user to the group");
  failWindow("cannot allocate " + std::to_string(size) + " bytes for " + fresh, error, "free disk space");
}

/// Replaces the file atomically; existing mappings keep the old one.
void replaceWindow(const std::string& fresh, const std::string& path) {
  if (::rename(fresh.c_str(), path.c_str()) == 0) return;
  const int error = errno;
  ::unlink(fresh.c_str());
  failWindow("cannot replace " + path, error,
             "if no controller is running, remove the file of another user: sudo rm " + path);
}

/// Another process may have replaced the file.
void removeIfSame(int file, const std::string& path) noexcept {
  struct stat ours {
  }, there{};
  if (file < 0 || ::fstat(file, &ours) != 0 || ::lstat(path.c_str(), &there) != 0) return;
  if (ours.st_dev == there.st_dev && ours.st_ino == there.st_ino) ::unlink(path.c_str());
}

}  // namespace

Writer::Writer(WindowFiles files, gid_t group) : files_{std::move(files)} {
  const std::string ending = ".new." + std::to_string(::getpid());
  try {
    asked_ = makeFresh(files_.asked + ending, 0660, group, sizeof(std::int64_t));
    replaceWindow(files_.asked + ending, files_.asked);
    pictures_ = makeFresh(files_.pictures + ending, 0640, group, sizeof(SharedWindow));
    try {
      memory_ = GuardedMapping{pictures_, sizeof(SharedWindow), PROT_READ | PROT_WRITE};
    } catch (const std::system_error& error) {
      ::unlink((files_.pictures + ending).c_str());
      failWindow("cannot map " + files_.pictures, error.code().value(), "end other programs");
    }
    window_ = new (memory_.data()) SharedWindow{};
    replaceWindow(files_.pictures + ending, files_.pictures);
  } catch (...) {
    removeOwn();
    throw;
  }
}

Writer::~Writer() {
  removeOwn();
}

void Writer::removeOwn() noexcept {
  removeIfSame(pictures_, files_.pictures);
  removeIfSame(asked_, files_.asked);
  if (pictures_ >= 0) ::close(pictures_);
  if (asked_ >= 0) ::close(asked_);
}

bool Writer::asked(Nanos now) const noexcept {
  std::int64_t stamp = 0;
  if (::pread(asked_, &stamp, sizeof stamp, 0) != sizeof stamp) return false;  // truncated by another process
  return stamp > 0 && stamp <= now.count() && now.count() - stamp < kAsked.count();
}

bool Writer::put(const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time, Nanos now) noexcept {
  const bool fits = image.width == kWidth && image.height == kHeight;
  const auto other =
      static_cast<std::uint32_t>(image.width) << 16 | (static_cast<std::uint32_t>(image.height) & 0xFFFF);
  window_->other_size.store(fits ? 0 : other, std::memory_order_relaxed);
  if (!fits || !asked(now)) return false;
  Slot& slot = window_->slots[next_];
  const std::uint32_t turn = slot.turn.load(std::memory_order_relaxed);
  slot.turn.store(turn + 1, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);  // a reader that sees new bytes also sees the odd turn
  slot.sequence = sequence;
  slot.time_ns = time.count();
  pixels::copyWithoutGaps(image, slot.bytes);
  slot.turn.store(turn + 2, std::memory_order_release);
  window_->newest.store(next_ + 1, std::memory_order_release);
  next_ = (next_ + 1) % SharedWindow::kSlots;
  return true;
}

}  // namespace darwinop::shared_picture
