// Opens, configures and rediscovers serial ports.
#include "hal/cm730/serial_open.hpp"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hal/fork_guard.hpp"

namespace darwinop::cm730 {
namespace {

using Step = OpenAttempt::Step;

// Flags left by a previous owner would corrupt data: with IXOFF an FTDI chip removes 0x11 and 0x13.
constexpr tcflag_t kControlFlags = CS8 | CREAD | CLOCAL;
constexpr tcflag_t kHarmfulControlFlags = CSTOPB | PARENB | PARODD | CMSPAR | CRTSCTS | HUPCL;

/// Sets all flags, independent of the previous owner. The settings persist after closing.
bool makeRaw(int fd) {
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) return false;
  settings.c_iflag = settings.c_oflag = settings.c_lflag = 0;
  settings.c_cflag = kControlFlags;
  settings.c_cc[VMIN] = 0;  // read() never blocks; returns 0 without data
  settings.c_cc[VTIME] = 0;
  ::cfsetspeed(&settings, B1000000);
  if (::tcsetattr(fd, TCSANOW, &settings) != 0) return false;
  // tcsetattr() succeeds if any of the changes was made, so read them back.
  termios now{};
  if (::tcgetattr(fd, &now) != 0) return false;
  const bool plain = (now.c_iflag | now.c_oflag | now.c_lflag) == 0 && (now.c_cflag & CSIZE) == CS8 &&
                     (now.c_cflag & kHarmfulControlFlags) == 0;
  if (::cfgetospeed(&now) != B1000000 || !plain) {
    errno = EINVAL;
    return false;
  }
  return true;
}

/// With this flag the FTDI driver sets its latency timer to 1 ms without root. A pty does not support the call.
void askForLowLatency(int fd) {
  serial_struct settings{};
  if (::ioctl(fd, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(fd, TIOCSSERIAL, &settings);
}

bool isPty(int fd) {
  struct stat info {};
  constexpr unsigned kFirstPtyMajor = 136, kLastPtyMajor = 143;  // Linux: UNIX98 pty slaves
  if (::fstat(fd, &info) != 0) return false;
  const unsigned major_number = static_cast<unsigned>((info.st_rdev >> 8) & 0xFFF);
  return major_number >= kFirstPtyMajor && major_number <= kLastPtyMajor;
}

/// The lock also stops root; TIOCEXCL also stops programs that do not use locks. A pty keeps TIOCEXCL after its last
/// user has closed it, which would block the next one, so it gets the lock only.
bool lock(int fd) {
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) return false;
  return isPty(fd) || ::ioctl(fd, TIOCEXCL) == 0;
}

}  // namespace

OpenAttempt openSerial(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (fd < 0) return {-1, Step::kOpen, errno};
  const auto give_up = [fd](Step step) {
    const OpenAttempt failed{-1, step, errno};
    unguardFromForks(fd);
    ::close(fd);
    return failed;
  };
  guardFromForks(fd);
  if (::isatty(fd) == 0) return give_up(Step::kTerminal);
  // Lock first: the settings of a port that is in use must not change.
  if (!lock(fd)) return give_up(Step::kLock);
  if (!makeRaw(fd)) return give_up(Step::kTerminal);
  askForLowLatency(fd);
  if (latencyTimer(path).value_or(1) > 1) setLatencyTimer(path, 1);
  ::tcflush(fd, TCIOFLUSH);
  return {fd, Step::kOpen, 0};
}

void closeSerial(int fd) {
  if (fd < 0) return;
  ::ioctl(fd, TIOCNXCL);
  unguardFromForks(fd);
  ::close(fd);
}

PortMemory::PortMemory(std::string path)
    : path_{std::move(path)}, identity_{usbIdentity(path_)}, link_{markOf(path_)} {}

std::optional<PortMemory::LinkMark> PortMemory::markOf(const std::string& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0 || !S_ISLNK(info.st_mode)) return std::nullopt;
  return LinkMark{info.st_ino, info.st_mtim.tv_sec, info.st_mtim.tv_nsec};
}

/// A pty that hung up never returns, and its number may be reused by a terminal: accept it only if the link to it was
/// recreated. A USB port must be the same device.
bool PortMemory::mayBeOurs() const {
  std::error_code error;
  const std::string real = std::filesystem::canonical(path_, error).string();
  if (error) return false;
  if (real.starts_with("/dev/pts/")) {
    const auto link = markOf(path_);
    return link && link != link_;
  }
  return !identity_ || usbIdentity(path_) == identity_;
}

int PortMemory::reopen() const {
  if (mayBeOurs()) {
    const OpenAttempt attempt = openSerial(path_);
    if (attempt.fd >= 0) return attempt.fd;
  }
  if (!path_.starts_with("/dev/ttyUSB")) return -1;
  for (const std::string& other : siblings(path_, identity_)) {
    const OpenAttempt attempt = openSerial(other);
    if (attempt.fd >= 0) return attempt.fd;
  }
  return -1;
}

}  // namespace darwinop::cm730
