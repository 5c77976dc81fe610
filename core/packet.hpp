// Dynamixel protocol 1.0 over byte spans: encode instructions, find and check frames in a byte stream.
// Instruction: FF FF id len inst p1..pn chk    Status: FF FF id len err p1..pn chk
// len = n + 2; chk = ~(id + len + inst|err + sum of p); a word is little-endian; no byte stuffing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace darwinop {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::uint8_t kBroadcastId = 254;
inline constexpr std::size_t kFrameHeader = 5;     // FF FF id len inst|err
inline constexpr std::size_t kFrameOverhead = 6;   // FF FF id len inst|err chk
inline constexpr std::size_t kMaxFrame = 255 + 4;  // the length byte bounds a frame

enum class Instruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kReset = 0x06,
  kSyncWrite = 0x83,
  kBulkRead = 0x92,
};

/// Bits of the error byte in a status packet (MX-28 manual).
namespace error_bit {
inline constexpr std::uint8_t kVoltage = 1, kAngleLimit = 2, kOverheat = 4, kRange = 8, kChecksum = 16, kOverload = 32,
                              kInstruction = 64;
}

/// Sum that makes a frame valid. `body` is id, len, inst|err and parameters: the frame without FF FF and chk.
std::uint8_t checksum(Bytes body);

/// Writes one instruction frame into `out` and returns it; empty if it does not fit or `params` has more than 253
/// bytes.
std::span<std::uint8_t> encodeInstruction(std::span<std::uint8_t> out, std::uint8_t id, Instruction instruction,
                                          Bytes params);
std::span<std::uint8_t> encodePing(std::span<std::uint8_t> out, std::uint8_t id);
std::span<std::uint8_t> encodeRead(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address,
                                   std::uint8_t count);
std::span<std::uint8_t> encodeWrite(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address, Bytes data);
/// Status frame, for the virtual devices.
std::span<std::uint8_t> encodeStatus(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t error, Bytes params);

/// Completes a frame whose parameters are already in place behind the header. `out` must have room for them plus
/// kFrameOverhead.
std::span<std::uint8_t> sealFrame(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t code, std::size_t params);

/// Appends parameter bytes to a frame under construction.
class FrameParams {
 public:
  explicit FrameParams(std::span<std::uint8_t> out)
      : out_{out}, limit_{out.empty() ? 0 : std::min(out.size() - 1, kFrameHeader + 253)} {}

  /// True if this many more bytes fit into `out` and the length byte.
  [[nodiscard]] bool fits(std::size_t bytes) const { return end_ + bytes <= limit_; }
  /// Requires fits().
  void put(std::uint8_t byte) { out_[end_++] = byte; }
  [[nodiscard]] std::size_t count() const { return end_ - kFrameHeader; }
  std::span<std::uint8_t> seal(Instruction instruction) const {
    return sealFrame(out_, kBroadcastId, static_cast<std::uint8_t>(instruction), count());
  }

 private:
  std::span<std::uint8_t> out_;
  std::size_t limit_, end_ = kFrameHeader;
};

/// Builds a SYNC_WRITE entry by entry. All entries have the same address and length.
class SyncWriteEncoder {
 public:
  SyncWriteEncoder(std::span<std::uint8_t> out, std::uint8_t address, std::uint8_t bytes_per_device)
      : params_{out}, data_bytes_{bytes_per_device} {
    if (!params_.fits(2)) return;
    params_.put(address);
    params_.put(bytes_per_device);
  }
  /// False, and nothing added, when `data` has another length or the frame would pass 255 bytes.
  bool add(std::uint8_t id, Bytes data) {
    if (data.size() != data_bytes_ || !params_.fits(1 + data.size())) return false;
    params_.put(id);
    for (const std::uint8_t byte : data) params_.put(byte);
    return true;
  }
  /// The finished frame; empty if nothing was added: an empty sync write must not be sent.
  std::span<std::uint8_t> finish() const {
    return params_.count() > 2 ? params_.seal(Instruction::kSyncWrite) : std::span<std::uint8_t>{};
  }

 private:
  FrameParams params_;
  std::uint8_t data_bytes_;
};

/// Builds a BULK_READ entry by entry; devices answer in this order, each waiting for the one before it.
class BulkReadEncoder {
 public:
  explicit BulkReadEncoder(std::span<std::uint8_t> out) : params_{out} {
    if (params_.fits(1)) params_.put(0x00);
  }
  bool add(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
    if (params_.count() < 1 || !params_.fits(3)) return false;
    params_.put(count);
    params_.put(id);
    params_.put(address);
    return true;
  }
  std::span<std::uint8_t> finish() const {
    return params_.count() > 1 ? params_.seal(Instruction::kBulkRead) : std::span<std::uint8_t>{};
  }

 private:
  FrameParams params_;
};

/// A frame in a stream: instruction or status; only the sender distinguishes them.
struct Frame {
  std::uint8_t id = 0;
  std::uint8_t code = 0;  // instruction, or error bits of a status
  Bytes params;           // points into the reader; valid until it is fed again
};

/// Finds frames in a byte stream and resynchronises after garbage: a candidate with a bad length or checksum
/// costs one byte, not a frame. Never allocates.
class FrameReader {
 public:
  static constexpr std::size_t kRoom = 512;
  /// Free space for the next bytes: at least kRoom once next() has returned nothing. May move bytes held.
  std::span<std::uint8_t> room() {
    if (pending() == 0)
      begin_ = end_ = 0;
    else if (begin_ > 0)
      moveTailToFront();  // so that a whole frame always fits behind it
    return std::span{buffer_}.subspan(end_);
  }
  /// `count` bytes were written to room().
  void taken(std::size_t count) { end_ += count; }
  /// Copies as many bytes as fit and returns their number; call next() until it returns nothing, then feed the rest.
  std::size_t feed(Bytes bytes);
  /// The next valid frame, or nothing if more bytes are needed. `more_expected` false: no more bytes will arrive, so an
  /// incomplete candidate is dropped and frames behind it are found.
  std::optional<Frame> next(bool more_expected = true) {
    return pending() < kFrameOverhead && more_expected ? std::nullopt : find(more_expected);
  }
  /// True once after a call of next() that found no header at the end of the previous frame. That frame may have lost
  /// or gained a byte and have a valid checksum by chance: with a byte lost, the FF of the next header is its checksum.
  [[nodiscard]] bool boundaryLost() { return boundary_lost_ && std::exchange(boundary_lost_, false); }
  /// Drops bytes held, keeps the counters.
  void clear() {
    begin_ = end_ = 0;
    at_boundary_ = boundary_lost_ = false;
  }

  [[nodiscard]] std::uint32_t garbageBytes() const { return garbage_bytes_; }
  [[nodiscard]] std::uint32_t badChecksums() const { return bad_checksums_; }
  /// Bytes held that are not a frame yet.
  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }

 private:
  std::optional<Frame> find(bool more_expected);
  void moveTailToFront();
  void skip(std::size_t bytes);
  std::array<std::uint8_t, kMaxFrame + kRoom> buffer_{};
  std::size_t begin_ = 0, end_ = 0;
  bool at_boundary_ = false;  // a frame ends at begin_
  bool boundary_lost_ = false;
  std::uint32_t garbage_bytes_ = 0, bad_checksums_ = 0;
};

constexpr std::uint16_t wordAt(Bytes bytes, std::size_t offset) {
  return static_cast<std::uint16_t>(bytes[offset] | (bytes[offset + 1] << 8));
}
constexpr std::uint8_t lowByte(std::uint16_t word) {
  return static_cast<std::uint8_t>(word & 0xFF);
}
constexpr std::uint8_t highByte(std::uint16_t word) {
  return static_cast<std::uint8_t>(word >> 8);
}

}  // namespace darwinop
