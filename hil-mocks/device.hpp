// Common base of CM-730 and MX-28: a control table that executes instructions.
#pragma once

#include <array>
#include <cstdint>

#include "hal/byte_line.hpp"
#include "hil-mocks/control_table.hpp"

namespace darwinop::hil {

class BusDevice {
 public:
  struct Answer {
    bool send = false;
    std::uint8_t error = 0;
    Bytes params{};
  };

  explicit BusDevice(const TableLayout& layout) : table_{layout} {}
  virtual ~BusDevice() = default;
  BusDevice(const BusDevice&) = default;
  BusDevice& operator=(const BusDevice&) = default;

  [[nodiscard]] std::uint8_t id() const { return table_.byte(kIdAddress); }
  [[nodiscard]] Nanos returnDelay() const { return kDelayUnit * table_.byte(kDelayAddress); }
  [[nodiscard]] std::uint8_t statusLevel() const { return table_.byte(kLevelAddress); }
  [[nodiscard]] const ControlTable& table() const { return table_; }

  /// Status packet for an instruction, from the state before it takes effect.
  [[nodiscard]] Answer answer(std::uint8_t instruction, Bytes params) const;
  /// Error byte and data for one entry of a BULK_READ, or for a READ.
  [[nodiscard]] Answer answerRead(std::uint8_t address, std::uint8_t count) const;
  [[nodiscard]] Answer answerBadChecksum(std::uint8_t instruction) const;
  /// Executes an instruction; not called if its status had a RANGE, ANGLE_LIMIT or INSTRUCTION bit.
  void carryOut(std::uint8_t instruction, Bytes params);
  void writeIfAccepted(std::uint8_t address, Bytes data);

 protected:
  static constexpr std::uint8_t kIdAddress = servo::kId, kDelayAddress = servo::kReturnDelay,
                                kLevelAddress = servo::kStatusLevel;
  static_assert(find(kCm730, "id").address == kIdAddress && find(kCm730, "return_delay").address == kDelayAddress &&
                find(kCm730, "status_level").address == kLevelAddress);

  /// Bits in every status while their cause lasts.
  [[nodiscard]] virtual std::uint8_t standingErrors() const = 0;
  /// Error bits of a write; 0: accepted.
  [[nodiscard]] virtual std::uint8_t objections(std::uint8_t address, Bytes data) const;
  virtual void write(std::uint8_t address, Bytes data) { table_.write(address, data); }
  virtual void noteRefusal(std::uint8_t /*errors*/) {}
  virtual void factoryReset() = 0;
  virtual void showRegistered(bool /*waiting*/) {}
  void forgetRegistered();

  ControlTable table_;

 private:
  static constexpr Nanos kDelayUnit = std::chrono::microseconds{2};
  std::array<std::uint8_t, kMaxFrame> registered_{};  // parameters of a pending REG_WRITE
  std::size_t registered_size_ = 0;
};

}  // namespace darwinop::hil
