// A copy of the sysfs tree of USB serial adapters.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "support/temporary_folder.hpp"

namespace darwinop {

class UsbTree {
 public:
  void plug(const std::string& tty, const std::string& vendor, const std::string& serial, int latency = 16) {
    plugInto("1-1." + serial, tty, vendor, serial, latency);
  }
  /// Without a serial number there is no file for it.
  void plugInto(const std::string& socket, const std::string& tty, const std::string& vendor = "0403",
                const std::string& serial = "", int latency = 16) {
    const std::filesystem::path usb = std::filesystem::path{folder_ / "devices"} / socket;
    const std::filesystem::path port = usb / (socket + ":1.0") / tty;
    std::filesystem::create_directories(port);
    std::ofstream{usb / "idVendor"} << vendor << '\n';
    std::ofstream{usb / "idProduct"} << "6001\n";
    if (!serial.empty()) std::ofstream{usb / "serial"} << serial << '\n';
    std::ofstream{port / "latency_timer"} << latency << '\n';
    std::filesystem::create_directories(std::filesystem::path{root()} / tty);
    std::filesystem::create_directory_symlink(port, std::filesystem::path{root()} / tty / "device");
  }
  void unplug(const std::string& tty) { std::filesystem::remove_all(std::filesystem::path{root()} / tty); }
  [[nodiscard]] std::string root() const { return folder_ / "tty"; }

 private:
  TemporaryFolder folder_;
};

}  // namespace darwinop
