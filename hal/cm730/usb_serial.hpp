// What sysfs tells of a USB serial port: which device it is, and how long its chip holds bytes back.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace darwinop::cm730 {

inline const std::string kSysTty = "/sys/class/tty";

/// "/dev/ttyUSB0", or a link to it, becomes "ttyUSB0".
std::string ttyName(const std::string& path);

/// Vendor, product and serial number as sysfs writes them; empty where it is silent.
struct UsbIdentity {
  std::string vendor, product, serial;
  bool operator==(const UsbIdentity&) const = default;
  [[nodiscard]] bool ftdi() const { return vendor == "0403"; }
};
/// Nothing for a port that is not on USB.
std::optional<UsbIdentity> usbIdentity(const std::string& path, const std::string& sys_tty = kSysTty);

/// /dev/ttyUSB0..7 that are the same device as `was` (any FTDI chip when that is not known), without `path`.
std::vector<std::string> siblings(const std::string& path, const std::optional<UsbIdentity>& was,
                                  const std::string& sys_tty = kSysTty);

/// An FTDI chip sends what it has when a 62 byte packet is full or this many ms have passed; 16 at plug-in.
std::optional<int> latencyTimer(const std::string& path, const std::string& sys_tty = kSysTty);
/// False when it is not permitted or there is none.
bool setLatencyTimer(const std::string& path, int ms, const std::string& sys_tty = kSysTty);
/// The command that does it by hand.
std::string latencyCommand(const std::string& path);

}  // namespace darwinop::cm730
