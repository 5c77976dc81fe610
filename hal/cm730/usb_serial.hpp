// sysfs attributes of a USB serial port: identity and latency timer.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace darwinop::cm730 {

inline const std::string kSysTty = "/sys/class/tty";

/// "/dev/ttyUSB0", or a link to it, becomes "ttyUSB0".
std::string ttyName(const std::string& path);

/// Vendor, product and serial number as in sysfs; empty if missing. All adapters of a product without serial numbers
/// are alike, and one may belong to another robot: such a one is identified by its USB socket.
struct UsbIdentity {
  std::string vendor, product, serial;
  std::string socket{};  // "1-1.2": bus and ports; empty if there is a serial number
  bool operator==(const UsbIdentity&) const = default;
};
/// Empty for a port that is not on USB.
std::optional<UsbIdentity> usbIdentity(const std::string& path, const std::string& sys_tty = kSysTty);

/// /dev/ttyUSB0..7 with the same identity as `was`, without `path`; none if it is unknown.
std::vector<std::string> siblings(const std::string& path, const std::optional<UsbIdentity>& was,
                                  const std::string& sys_tty = kSysTty);

/// Ports that may be the device `was`, now or under its new number: `path` first, unless it is another device by now.
std::vector<std::string> portsOf(const std::string& path, const std::optional<UsbIdentity>& was,
                                 const std::string& sys_tty = kSysTty);

/// An FTDI chip sends its buffer when 62 bytes are full or after this many ms; 16 by default.
std::optional<int> latencyTimer(const std::string& path, const std::string& sys_tty = kSysTty);
/// Returns false if not permitted or not available.
bool setLatencyTimer(const std::string& path, int ms, const std::string& sys_tty = kSysTty);
/// Shell command with the same effect.
std::string latencyCommand(const std::string& path);

}  // namespace darwinop::cm730
