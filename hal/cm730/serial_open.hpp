// Opens a serial port the way a CM-730 needs it, and says what is wrong in words when that fails.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/cm730/usb_serial.hpp"

namespace darwinop::cm730 {

/// `fd` is -1 when it failed; `error` is then the errno of `step`.
struct OpenAttempt {
  enum class Step { kOpen, kTerminal, kLock };
  int fd = -1;
  Step step = Step::kOpen;
  int error = 0;
};

/// Raw, 1 Mbaud, 8N1, no flow control, no hang-up on close, whatever a former owner had set; reads that never wait,
/// nobody else on the port, low latency where the driver has it. A pty will do. The caller closes `fd` with
/// closeSerial(), which leaves these settings.
OpenAttempt openSerial(const std::string& path);
void closeSerial(int fd);

/// True: the port is not there, or in use; it may be otherwise in a while.
[[nodiscard]] bool mayComeYet(const OpenAttempt& failed);

/// One sentence: what is wrong with this port and what to do about it.
std::string explain(const std::string& path, const OpenAttempt& failed);

/// Ports a CM-730 might hang on: ttyUSB* and ttyACM* in `dev`, sorted.
std::vector<std::string> candidatePorts(const std::string& dev = "/dev");

/// What is needed to find a port again after it went away.
class PortMemory {
 public:
  explicit PortMemory(std::string path);
  /// Tries the same path, then, for a /dev/ttyUSB*, its siblings that are the same device; -1: not there yet.
  [[nodiscard]] int reopen() const;

 private:
  /// Tells a link that was made anew from one that was left behind.
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
