#include "core/packet.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace darwinop {
namespace {

using Word = std::size_t;
constexpr Word kOnes = ~Word{0} / 0xFFFF, kLowBytes = kOnes * 0xFF;  // 0x0001'0001.., 0x00FF'00FF..
static_assert(std::endian::native == std::endian::little);

Word load(const std::uint8_t* bytes) {
  Word word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

/// Sums of two bytes each, in 16-bit fields.
Word pairs(Word word) {
  return (word & kLowBytes) + (word >> 8 & kLowBytes);
}

/// Sum of bytes, a machine word in a turn. The last word ends with the last byte; what it shares with the one before is
/// shifted out.
inline std::uint8_t sum(const std::uint8_t* bytes, std::size_t count) {
  if (count < sizeof(Word)) return static_cast<std::uint8_t>(std::accumulate(bytes, bytes + count, 0U));
  const std::uint8_t* const last = bytes + count - sizeof(Word);
  Word fields = 0;
  for (; bytes < last; bytes += sizeof(Word)) fields = (fields & kLowBytes) + pairs(load(bytes));
  fields = (fields & kLowBytes) + pairs(load(last) >> 8 * (bytes - last));
  return static_cast<std::uint8_t>(fields * kOnes >>
                                   (8 * sizeof(Word) - 16));  // the topmost field holds the sum of all
}

}  // namespace

std::uint8_t checksum(Bytes body) {
  return static_cast<std::uint8_t>(~sum(body.data(), body.size()));
}

std::span<std::uint8_t> sealFrame(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t code, std::size_t params) {
  out[0] = out[1] = 0xFF;
  out[2] = id;
  out[3] = static_cast<std::uint8_t>(params + 2);
  out[4] = code;
  out[kFrameHeader + params] = static_cast<std::uint8_t>(~sum(&out[2], params + 3));
  return out.first(params + kFrameOverhead);
}

namespace {

std::span<std::uint8_t> encode(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t code, Bytes params) {
  if (params.size() > 253 || out.size() < params.size() + kFrameOverhead) return {};
  std::ranges::copy(params, out.begin() + kFrameHeader);
  return sealFrame(out, id, code, params.size());
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
  out[kFrameHeader] = address;
  std::ranges::copy(data, out.begin() + kFrameHeader + 1);
  return sealFrame(out, id, static_cast<std::uint8_t>(Instruction::kWrite), data.size() + 1);
}

std::span<std::uint8_t> encodeStatus(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t error, Bytes params) {
  return encode(out, id, error, params);
}

void FrameReader::moveTailToFront() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
}

std::size_t FrameReader::feed(Bytes bytes) {
  const std::size_t count = std::min(bytes.size(), room().size());
  std::copy_n(bytes.begin(), count, buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  taken(count);
  return count;
}

void FrameReader::skip(std::size_t bytes) {
  begin_ += bytes;
  at_boundary_ = false;
  garbage_bytes_ += static_cast<std::uint32_t>(bytes);
}

std::optional<Frame> FrameReader::find(bool more_expected) {
  for (; pending() >= kFrameOverhead; skip(1)) {
    const std::uint8_t* at = buffer_.data() + begin_;
    // A third FF cannot be an id: the frame starts one byte later.
    if (at[0] != 0xFF || at[1] != 0xFF || at[2] == 0xFF || at[3] < 2) {
      boundary_lost_ |= at_boundary_;
      continue;
    }
    const std::size_t size = std::size_t{at[3]} + 4;
    if (pending() < size) {
      if (more_expected) return std::nullopt;
      continue;
    }
    if (sum(at + 2, size - 2) != 0xFF) {  // its own checksum included
      ++bad_checksums_;
      continue;
    }
    begin_ += size;
    at_boundary_ = true;
    return Frame{at[2], at[4], Bytes{at + kFrameHeader, size - kFrameOverhead}};
  }
  boundary_lost_ |= at_boundary_ && !more_expected && pending() > 0;
  return std::nullopt;
}

}  // namespace darwinop
