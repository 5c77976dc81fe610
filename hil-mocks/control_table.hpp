// A device's control table: bytes, and the law of which writes it accepts.
#pragma once

#include <array>
#include <cstdint>

#include "core/packet.hpp"
#include "core/registers.hpp"

namespace darwinop::hil {

/// Which register covers which address; null: nothing there, reads as 0, refuses writes.
struct TableLayout {
  std::size_t size = 0;
  std::array<const Register*, kBoardTableSize> at{};
};

extern const TableLayout kBoardLayout;
extern const TableLayout kServoLayout;

class ControlTable {
 public:
  explicit ControlTable(const TableLayout& layout);

  [[nodiscard]] std::uint8_t byte(std::uint8_t address) const { return bytes_[address]; }
  [[nodiscard]] std::uint16_t word(std::uint8_t address) const { return wordAt(bytes_, address); }
  void setByte(std::uint8_t address, std::uint8_t value) { bytes_[address] = value; }
  void setWord(std::uint8_t address, std::uint16_t value);

  /// The part asked for; empty when it is not wholly inside the table or nothing is asked for.
  [[nodiscard]] Bytes read(std::uint8_t address, std::uint8_t count) const;
  /// False (error bit RANGE) for half a word, a read-only or absent address, or a value out of range.
  [[nodiscard]] bool accepts(std::uint8_t address, Bytes data) const;
  /// True when a write touches a register of this memory.
  [[nodiscard]] bool touches(Memory memory, std::uint8_t address, Bytes data) const;
  void write(std::uint8_t address, Bytes data);
  /// All registers of one memory to their reset values.
  void reset(Memory memory);

 private:
  const TableLayout* layout_;
  std::array<std::uint8_t, kBoardTableSize> bytes_{};
};

}  // namespace darwinop::hil
