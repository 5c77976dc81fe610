#include "core/packet.hpp"

#include <algorithm>

namespace darwinop {

std::uint8_t checksum(Bytes body) {
  unsigned sum = 0;
  for (const std::uint8_t byte : body) sum += byte;
  return static_cast<std::uint8_t>(~sum & 0xFF);
}

namespace {

constexpr std::size_t kHeader = 5;  // FF FF id len inst

/// Completes a frame whose parameters already stand behind the header.
std::span<std::uint8_t> seal(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t code, std::size_t params) {
  out[0] = out[1] = 0xFF;
  out[2] = id;
  out[3] = static_cast<std::uint8_t>(params + 2);
  out[4] = code;
  out[kHeader + params] = checksum(out.subspan(2, params + 3));
  return out.first(params + kFrameOverhead);
}

std::span<std::uint8_t> encode(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t code, Bytes params) {
  if (params.size() > 253 || out.size() < params.size() + kFrameOverhead) return {};
  std::ranges::copy(params, out.begin() + kHeader);
  return seal(out, id, code, params.size());
}

}  // namespace

std::span<std::uint8_t> encodeInstruction(std::span<std::uint8_t> out, std::uint8_t id, Instruction instruction,
                                          Bytes params) {
  return encode(out, id, static_cast<std::uint8_t>(instruction), params);
}

std::span<std::uint8_t> encodePing(std::span<std::uint8_t> out, std::uint8_t id) {
  return encodeInstruction(out, id, Instruction::kPing, {});
}

std::span<std::uint8_t> encodeRead(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address,
                                   std::uint8_t count) {
  const std::array<std::uint8_t, 2> params{address, count};
  return encodeInstruction(out, id, Instruction::kRead, params);
}

std::span<std::uint8_t> encodeWrite(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address, Bytes data) {
  if (data.size() > 252 || out.size() < data.size() + 1 + kFrameOverhead) return {};
  out[kHeader] = address;
  std::ranges::copy(data, out.begin() + kHeader + 1);
  return seal(out, id, static_cast<std::uint8_t>(Instruction::kWrite), data.size() + 1);
}

std::span<std::uint8_t> encodeStatus(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t error, Bytes params) {
  return encode(out, id, error, params);
}

SyncWriteEncoder::SyncWriteEncoder(std::span<std::uint8_t> out, std::uint8_t address, std::uint8_t bytes_per_device)
    : out_{out}, used_{kHeader + 2}, data_bytes_{bytes_per_device} {
  if (out_.size() < used_ + 1) return;
  out_[kHeader] = address;
  out_[kHeader + 1] = bytes_per_device;
}

bool SyncWriteEncoder::add(std::uint8_t id, Bytes data) {
  const std::size_t after = used_ + 1 + data.size();
  if (data.size() != data_bytes_ || after - kHeader > 253 || after + 1 > out_.size()) return false;
  out_[used_++] = id;
  std::ranges::copy(data, out_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = after;
  return true;
}

std::span<std::uint8_t> SyncWriteEncoder::finish() {
  if (used_ <= kHeader + 2) return {};
  return seal(out_, kBroadcastId, static_cast<std::uint8_t>(Instruction::kSyncWrite), used_ - kHeader);
}

BulkReadEncoder::BulkReadEncoder(std::span<std::uint8_t> out) : out_{out}, used_{kHeader + 1} {
  if (!out_.empty() && out_.size() > kHeader) out_[kHeader] = 0x00;
}

bool BulkReadEncoder::add(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
  if (used_ + 3 - kHeader > 253 || used_ + 4 > out_.size()) return false;
  out_[used_++] = count;
  out_[used_++] = id;
  out_[used_++] = address;
  return true;
}

std::span<std::uint8_t> BulkReadEncoder::finish() {
  if (used_ <= kHeader + 1) return {};
  return seal(out_, kBroadcastId, static_cast<std::uint8_t>(Instruction::kBulkRead), used_ - kHeader);
}

std::size_t FrameReader::feed(Bytes bytes) {
  if (begin_ > 0) {  // keep the tail at the front, so that a whole frame always fits behind it
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  const std::size_t taken = std::min(bytes.size(), buffer_.size() - end_);
  std::copy_n(bytes.begin(), taken, buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  end_ += taken;
  return taken;
}

void FrameReader::skip(std::size_t bytes) {
  begin_ += bytes;
  garbage_bytes_ += static_cast<std::uint32_t>(bytes);
}

std::optional<Frame> FrameReader::next(bool more_expected) {
  while (end_ - begin_ >= kFrameOverhead) {
    const std::uint8_t* at = buffer_.data() + begin_;
    // A third FF cannot be an id: the frame starts one byte later.
    if (at[0] != 0xFF || at[1] != 0xFF || at[2] == 0xFF || at[3] < 2) {
      skip(1);
      continue;
    }
    const std::size_t size = std::size_t{at[3]} + 4;
    if (end_ - begin_ < size) {
      if (more_expected) return std::nullopt;
      skip(1);
      continue;
    }
    if (checksum({at + 2, size - 3}) != at[size - 1]) {
      ++bad_checksums_;
      skip(1);
      continue;
    }
    begin_ += size;
    return Frame{at[2], at[4], Bytes{at + kHeader, size - kFrameOverhead}};
  }
  return std::nullopt;
}

void FrameReader::clear() {
  begin_ = end_ = 0;
}

}  // namespace darwinop
