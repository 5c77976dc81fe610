// Control table of a device: bytes and write rules.
#pragma once

#include <array>
#include <cstdint>

#include "core/packet.hpp"
#include "core/registers.hpp"

namespace darwinop::hil {

/// Register at each address; null: none, reads as 0 and rejects writes.
struct TableLayout {
  std::size_t size = 0;
  std::array<const Register*, kBoardTableSize> at{};
};

extern const TableLayout kBoardLayout;
extern const TableLayout kServoLayout;
extern const TableLayout kStrongerServoLayout;  // MX-64, MX-106

class ControlTable {
 public:
  explicit ControlTable(const TableLayout& layout);

  [[nodiscard]] std::uint8_t byte(std::uint8_t address) const { return bytes_[address]; }
  [[nodiscard]] std::uint16_t word(std::uint8_t address) const { return wordAt(bytes_, address); }
  void setByte(std::uint8_t address, std::uint8_t value) { bytes_[address] = value; }
  void setWord(std::uint8_t address, std::uint16_t value);

  /// Empty if not entirely inside the table, or of length 0.
  [[nodiscard]] Bytes read(std::uint8_t address, std::uint8_t count) const;
  /// Returns false (error bit RANGE) for half a word, a read-only or absent address, or a value out of range.
  [[nodiscard]] bool accepts(std::uint8_t address, Bytes data) const;
  /// True if a write touches a register of this memory.
  [[nodiscard]] bool touches(Memory memory, std::uint8_t address, Bytes data) const;
  void write(std::uint8_t address, Bytes data);
  /// Resets all registers of one memory.
  void reset(Memory memory);

 private:
  const TableLayout* layout_;
  std::array<std::uint8_t, kBoardTableSize> bytes_{};
};

}  // namespace darwinop::hil
