// Opens a port for the doctor and checks its settings.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/serial_port.hpp"

namespace darwinop::cm730 {

struct PortCheck {
  std::unique_ptr<SerialPort> port;  // null: cannot be opened; see the findings
  Findings findings;
};
PortCheck checkPort(const std::string& path);

/// Checks an FTDI latency timer in ms; no finding for a port without one.
Findings latencyRows(const std::string& path, const std::optional<int>& timer);

/// The port to check: `asked`, else the first existing one, else /dev/ttyUSB0. `asked` may be a DARWINOP_ROBOT setting;
/// throws std::runtime_error if it is not a port ("twin", "tcp://...").
std::string choosePort(const std::string& asked, const std::vector<std::string>& candidates);

}  // namespace darwinop::cm730
