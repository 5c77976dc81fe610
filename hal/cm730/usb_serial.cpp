// Reads /sys/class/tty for USB serial ports.
#include "hal/cm730/usb_serial.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace darwinop::cm730 {
namespace {

constexpr int kMostPorts = 8;

std::string firstWord(const std::string& file) {
  std::ifstream in{file};
  std::string word;
  in >> word;
  return word;
}

std::string deviceFolder(const std::string& path, const std::string& sys_tty) {
  return sys_tty + "/" + ttyName(path) + "/device/";
}

}  // namespace

std::string ttyName(const std::string& path) {
  std::error_code error;
  const auto real = std::filesystem::canonical(path, error);
  return (error ? std::filesystem::path{path} : real).filename().string();
}

std::optional<UsbIdentity> usbIdentity(const std::string& path, const std::string& sys_tty) {
  // .../1-1/1-1:1.0/ttyUSB0: the USB device is two folders above a usb-serial port, one above an ACM port. The folder
  // is a symbolic link, so the kernel must resolve "..".
  for (const char* up : {"../../", "../"}) {
    const std::string folder = deviceFolder(path, sys_tty) + up;
    const std::string vendor = firstWord(folder + "idVendor");
    if (vendor.empty()) continue;
    UsbIdentity found{vendor, firstWord(folder + "idProduct"), firstWord(folder + "serial")};
    std::error_code error;
    if (found.serial.empty()) found.socket = std::filesystem::canonical(folder, error).filename().string();
    return found;
  }
  return std::nullopt;
}

std::vector<std::string> siblings(const std::string& path, const std::optional<UsbIdentity>& was,
                                  const std::string& sys_tty) {
  std::vector<std::string> found;
  for (int i = 0; was && i < kMostPorts; ++i) {
    const std::string other = "/dev/ttyUSB" + std::to_string(i);
    if (other == path) continue;
    if (usbIdentity(other, sys_tty) == was) found.push_back(other);
  }
  return found;
}

std::vector<std::string> portsOf(const std::string& path, const std::optional<UsbIdentity>& was,
                                 const std::string& sys_tty) {
  std::vector<std::string> found = siblings(path, was, sys_tty);
  if (!was || usbIdentity(path, sys_tty) == was) found.insert(found.begin(), path);
  return found;
}

std::optional<int> latencyTimer(const std::string& path, const std::string& sys_tty) {
  std::ifstream in{deviceFolder(path, sys_tty) + "latency_timer"};
  int ms = 0;
  if (in >> ms) return ms;
  return std::nullopt;
}

bool setLatencyTimer(const std::string& path, int ms, const std::string& sys_tty) {
  if (!latencyTimer(path, sys_tty)) return false;  // must not create the file
  std::ofstream out{deviceFolder(path, sys_tty) + "latency_timer"};
  out << ms << std::flush;
  return out.good() && latencyTimer(path, sys_tty) == ms;
}

std::string latencyCommand(const std::string& path) {
  const std::string name = ttyName(path);
  if (!name.starts_with("ttyUSB")) return "set the latency timer of " + path + " to 1 ms";
  return "echo 1 | sudo tee /sys/bus/usb-serial/devices/" + name + "/latency_timer";
}

}  // namespace darwinop::cm730
