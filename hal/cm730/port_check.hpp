// Opens a port for the doctor: what is there, what is permitted, what its chip is set to.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/cm730/finding.hpp"
#include "hal/cm730/serial_port.hpp"

namespace darwinop::cm730 {

struct PortCheck {
  std::unique_ptr<SerialPort> port;  // null: it could not be opened, and the findings say why
  Findings findings;
};
PortCheck checkPort(const std::string& path);

/// Judges an FTDI latency timer in ms; no row for a port that has none.
Findings latencyRows(const std::string& path, const std::optional<int>& timer);

/// The port to look at: what was asked for, else the first that is there, else /dev/ttyUSB0. `asked` may be a
/// DARWINOP_ROBOT setting; throws std::runtime_error when it names something that is no port ("twin", "tcp://...").
std::string choosePort(const std::string& asked, const std::vector<std::string>& candidates);

}  // namespace darwinop::cm730
