// Write rules of CM-730 firmware; also used for servos.
#include "hil-mocks/control_table.hpp"

#include <algorithm>

namespace darwinop::hil {
namespace {

template <std::size_t N>
constexpr TableLayout layoutOf(const std::array<Register, N>& rows, std::size_t size) {
  TableLayout layout{size};
  for (const Register& row : rows)
    for (std::size_t i = 0; i < row.bytes; ++i) layout.at[row.address + i] = &row;
  return layout;
}

constexpr TableLayout strongerServoLayout() {
  TableLayout layout = layoutOf(kMx28, kServoTableSize);
  for (const Register& row : kStrongerMx) layout.at[row.address] = &row;  // of one byte
  return layout;
}
static_assert(std::ranges::all_of(kStrongerMx, [](const Register& row) { return row.bytes == 1; }));

}  // namespace

constinit const TableLayout kBoardLayout = layoutOf(kCm730, kBoardTableSize);
constinit const TableLayout kServoLayout = layoutOf(kMx28, kServoTableSize);
constinit const TableLayout kStrongerServoLayout = strongerServoLayout();

ControlTable::ControlTable(const TableLayout& layout) : layout_{&layout} {
  reset(Memory::kEeprom);
  reset(Memory::kRam);
}

void ControlTable::setWord(std::uint8_t address, std::uint16_t value) {
  bytes_[address] = lowByte(value);
  bytes_[address + 1u] = highByte(value);
}

Bytes ControlTable::read(std::uint8_t address, std::uint8_t count) const {
  if (count == 0 || std::size_t{address} + count > layout_->size) return {};
  return Bytes{bytes_}.subspan(address, count);
}

bool ControlTable::accepts(std::uint8_t address, Bytes data) const {
  if (data.empty() || address + data.size() > layout_->size) return false;
  for (std::size_t at = address; at < address + data.size();) {
    const Register* row = layout_->at[at];
    if (row == nullptr || row->access != Access::kReadWrite || row->address != at) return false;
    if (at + row->bytes > address + data.size()) return false;  // ends inside a word
    const std::size_t offset = at - address;
    const std::uint16_t value = row->bytes == 2 ? wordAt(data, offset) : data[offset];
    if (value < row->low || value > row->high) return false;
    at += row->bytes;
  }
  return true;
}

bool ControlTable::touches(Memory memory, std::uint8_t address, Bytes data) const {
  for (std::size_t at = address; at < std::min(address + data.size(), layout_->size); ++at)
    if (layout_->at[at] != nullptr && layout_->at[at]->memory == memory) return true;
  return false;
}

void ControlTable::write(std::uint8_t address, Bytes data) {
  std::ranges::copy(data, bytes_.begin() + address);
}

void ControlTable::reset(Memory memory) {
  for (std::size_t at = 0; at < layout_->size; ++at) {
    const Register* row = layout_->at[at];
    if (row == nullptr || row->memory != memory) continue;
    bytes_[at] = at == row->address ? lowByte(row->reset) : highByte(row->reset);
  }
}

}  // namespace darwinop::hil
