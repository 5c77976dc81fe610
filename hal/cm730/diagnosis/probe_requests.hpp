// Requests of a probe: with one patience, and with a note of a lost port.
#pragma once

#include <cstdint>

#include "hal/cm730/diagnosis/transactions.hpp"

namespace darwinop::cm730 {

class ProbeRequests {
 public:
  /// `lost` becomes true with the first request that finds the port lost. Both must outlive this.
  ProbeRequests(ByteLine& line, bool& lost) : line_{line}, lost_{lost} {}

  const Answer& note(const Answer& answer) {
    if (answer.status == LineStatus::kLost) lost_ = true;
    return answer;
  }
  Answer ping(std::uint8_t id) { return note(cm730::ping(line_, id, patience)); }
  Answer read(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
    return note(readRegisters(line_, id, address, count, patience));
  }
  /// Writes once: a lost reply must not cost a second EEPROM write cycle.
  Answer writeOnce(std::uint8_t id, std::uint8_t address, std::uint8_t value) {
    return note(writeRegisters(line_, id, address, Bytes{&value, 1}, {1, patience.margin}));
  }

  Patience patience;

 private:
  ByteLine& line_;
  bool& lost_;
};

}  // namespace darwinop::cm730
