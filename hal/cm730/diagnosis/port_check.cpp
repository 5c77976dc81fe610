// Serial port check of the doctor.
#include "hal/cm730/diagnosis/port_check.hpp"

#include <stdexcept>

#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_open.hpp"
#include "hal/cm730/usb_serial.hpp"

namespace darwinop::cm730 {

Findings latencyRows(const std::string& path, const std::optional<int>& timer) {
  if (!timer) return {};
  const std::string what = "FTDI latency timer of " + ttyName(path) + " is " + std::to_string(*timer) + " ms";
  if (*timer <= 1) return {Finding::ok(what)};
  return {Finding::of(Kind::kLatencyTimer, what + " (required: 1)",
                      latencyCommand(path) + "   (permanently: udev rule in docs/doctor.md)")};
}

PortCheck checkPort(const std::string& path) {
  PortCheck check;
  try {
    check.port = std::make_unique<SerialPort>(path);
  } catch (const NotReady& error) {
    check.findings.push_back(Finding::of(Kind::kPortMissing, error.what(), {}));
    return check;
  } catch (const std::runtime_error& error) {
    check.findings.push_back(Finding::of(Kind::kPortUnusable, error.what(), {}));
    return check;
  }
  check.findings.push_back(Finding::ok("port " + path + " opened at 1 Mbaud"));
  const Findings latency = latencyRows(path, latencyTimer(path));
  check.findings.insert(check.findings.end(), latency.begin(), latency.end());
  return check;
}

std::string choosePort(const std::string& asked, const std::vector<std::string>& candidates) {
  if (asked.empty()) return candidates.empty() ? "/dev/ttyUSB0" : candidates.front();
  if (asked == "runtime")
    throw std::runtime_error{
        "'runtime' is the daemon, which has the robot's port open: query it with `darwinop runtime "
        "--status`, or stop it and name the port, for example: darwinop doctor --robot /dev/ttyUSB0"};
  if (asked == "virtual")
    throw std::runtime_error{
        "'virtual' is a robot inside one controller and cannot be checked from outside: start "
        "`darwinop virtual-robot` and use the path that it prints, for example: darwinop doctor --robot /tmp/robot"};
  if (asked.find('/') == std::string::npos || asked.find("://") != std::string::npos)
    throw std::runtime_error{"'" + asked +
                             "' is not a serial port: use the robot's port, for example "
                             "--robot /dev/ttyUSB0, or the path that `darwinop virtual-robot` prints"};
  return asked;
}

}  // namespace darwinop::cm730
