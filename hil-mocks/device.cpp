// Protocol 1.0 instructions: replies and effects.
#include "hil-mocks/device.hpp"

#include <algorithm>

namespace darwinop::hil {
namespace {

constexpr Instruction kind(std::uint8_t instruction) {
  return static_cast<Instruction>(instruction);
}

}  // namespace

std::uint8_t BusDevice::objections(std::uint8_t address, Bytes data) const {
  return table_.accepts(address, data) ? 0 : error_bit::kRange;
}

BusDevice::Answer BusDevice::answerRead(std::uint8_t address, std::uint8_t count) const {
  const Bytes bytes = table_.read(address, count);
  const std::uint8_t error = bytes.empty() ? error_bit::kRange : std::uint8_t{0};
  return {statusLevel() >= 1, static_cast<std::uint8_t>(standingErrors() | error), bytes};
}

BusDevice::Answer BusDevice::answerBadChecksum(std::uint8_t instruction) const {
  const bool send = kind(instruction) != Instruction::kPing && statusLevel() >= 1;
  return {send, static_cast<std::uint8_t>(standingErrors() | error_bit::kChecksum)};
}

BusDevice::Answer BusDevice::answer(std::uint8_t instruction, Bytes params) const {
  std::uint8_t error = 0;
  switch (kind(instruction)) {
    case Instruction::kPing:
      return {true, standingErrors()};
    case Instruction::kRead:
      return params.size() == 2 ? answerRead(params[0], params[1]) : answerRead(0, 0);
    case Instruction::kWrite:
    case Instruction::kRegWrite:
      error = params.size() < 2 ? error_bit::kRange : objections(params[0], params.subspan(1));
      break;
    case Instruction::kAction:
      error = registered_size_ == 0 ? error_bit::kInstruction : std::uint8_t{0};
      break;
    case Instruction::kReset:
      error = params.empty() ? std::uint8_t{0} : error_bit::kRange;
      break;
    default:  // unknown, or SYNC_WRITE or BULK_READ to a single device
      error = error_bit::kInstruction;
  }
  return {statusLevel() >= 2, static_cast<std::uint8_t>(standingErrors() | error)};
}

void BusDevice::writeIfAccepted(std::uint8_t address, Bytes data) {
  const std::uint8_t errors = objections(address, data);
  noteRefusal(errors);
  if (errors == 0) write(address, data);
}

void BusDevice::carryOut(std::uint8_t instruction, Bytes params) {
  switch (kind(instruction)) {
    case Instruction::kWrite:
      if (params.size() >= 2) writeIfAccepted(params[0], params.subspan(1));
      break;
    case Instruction::kRegWrite:
      if (params.size() < 2 || objections(params[0], params.subspan(1)) != 0) break;
      std::ranges::copy(params, registered_.begin());
      registered_size_ = params.size();
      showRegistered(true);
      break;
    case Instruction::kAction:
      if (registered_size_ == 0) break;
      writeIfAccepted(registered_[0], Bytes{registered_}.subspan(1, registered_size_ - 1));
      forgetRegistered();
      break;
    case Instruction::kReset:
      if (params.empty()) factoryReset();
      break;
    default:
      break;
  }
}

void BusDevice::forgetRegistered() {
  registered_size_ = 0;
  showRegistered(false);
}

}  // namespace darwinop::hil
