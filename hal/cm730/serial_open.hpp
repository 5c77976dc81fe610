// Opens a serial port for a CM-730; error messages with remedies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/cm730/usb_serial.hpp"

namespace darwinop::cm730 {

// Phrases of the messages, after the port's name.
inline constexpr const char* kNoSuchPort = " does not exist";
inline constexpr const char* kPortInUse = " is in use by ";
inline constexpr const char* kNotASerialPort = " is not a serial port";

/// On failure `fd` is -1 and `error` the errno of `step`.
struct OpenAttempt {
  enum class Step { kOpen, kTerminal, kLock };
  int fd = -1;
  Step step = Step::kOpen;
  int error = 0;
};

/// Raw, 1 Mbaud, 8N1, no flow control, no hang-up on close; non-blocking reads, exclusive access, low latency if the
/// driver supports it. A pty works. A forked child does not share it (fork_guard.hpp). The caller closes `fd` with
/// closeSerial(), which keeps these settings.
OpenAttempt openSerial(const std::string& path);
void closeSerial(int fd);

/// True: the port is missing or in use; retrying is useful.
[[nodiscard]] bool mayComeYet(const OpenAttempt& failed);

/// Error message with a remedy.
std::string explain(const std::string& path, const OpenAttempt& failed);

/// Possible CM-730 ports: ttyUSB* and ttyACM* in `dev`, sorted.
std::vector<std::string> candidatePorts(const std::string& dev = "/dev");

/// Identity of a port, to find it again after it was lost.
class PortMemory {
 public:
  explicit PortMemory(std::string path);
  /// Tries the same path; for a /dev/ttyUSB* also its siblings with the same identity. Returns -1: not there yet.
  [[nodiscard]] int reopen() const;

 private:
  /// Distinguishes a recreated link from a stale one.
  struct LinkMark {
    unsigned long long inode = 0;
    long long seconds = 0, nanoseconds = 0;
    bool operator==(const LinkMark&) const = default;
  };
  static std::optional<LinkMark> markOf(const std::string& path);
  [[nodiscard]] bool mayBeOurs() const;

  std::string path_;
  std::optional<UsbIdentity> identity_;
  std::optional<LinkMark> link_;
};

}  // namespace darwinop::cm730
