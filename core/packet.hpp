// Dynamixel protocol 1.0 over byte spans: encode instructions, find and check frames in a byte stream.
// Instruction: FF FF id len inst p1..pn chk    Status: FF FF id len err p1..pn chk
// len = n + 2; chk = ~(id + len + inst|err + sum of p); a word is little-endian; no byte stuffing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace darwinop {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::uint8_t kBroadcastId = 254;
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

/// Writes one instruction frame into `out` and returns the part used; empty if it does not fit or `params`
/// has more than 253 bytes.
std::span<std::uint8_t> encodeInstruction(std::span<std::uint8_t> out, std::uint8_t id, Instruction instruction,
                                          Bytes params);
std::span<std::uint8_t> encodePing(std::span<std::uint8_t> out, std::uint8_t id);
std::span<std::uint8_t> encodeRead(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address,
                                   std::uint8_t count);
std::span<std::uint8_t> encodeWrite(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t address, Bytes data);
/// Status frame, for the virtual devices.
std::span<std::uint8_t> encodeStatus(std::span<std::uint8_t> out, std::uint8_t id, std::uint8_t error, Bytes params);

/// Builds a SYNC_WRITE entry by entry. All entries have the same address and length.
class SyncWriteEncoder {
 public:
  SyncWriteEncoder(std::span<std::uint8_t> out, std::uint8_t address, std::uint8_t bytes_per_device);
  /// False, and nothing added, when `data` has another length or the frame would pass 255 bytes.
  bool add(std::uint8_t id, Bytes data);
  /// The finished frame; empty when nothing was added: an empty sync write is never sent.
  std::span<std::uint8_t> finish();

 private:
  std::span<std::uint8_t> out_;
  std::size_t used_;
  std::uint8_t data_bytes_;
};

/// Builds a BULK_READ entry by entry; devices answer in this order, each waiting for the one before it.
class BulkReadEncoder {
 public:
  explicit BulkReadEncoder(std::span<std::uint8_t> out);
  bool add(std::uint8_t id, std::uint8_t address, std::uint8_t count);
  std::span<std::uint8_t> finish();

 private:
  std::span<std::uint8_t> out_;
  std::size_t used_;
};

/// A frame found in a stream: instruction or status, told apart only by who sent it.
struct Frame {
  std::uint8_t id = 0;
  std::uint8_t code = 0;  // instruction, or error bits of a status
  Bytes params;           // points into the reader; valid until it is fed again
};

/// Finds frames in a byte stream and resynchronises after garbage: a candidate with a bad length or checksum
/// costs one byte, not a frame. Holds at most one frame and a tail; never allocates.
class FrameReader {
 public:
  /// Takes as many bytes as fit and returns how many; call next() until it is empty, then feed the rest.
  std::size_t feed(Bytes bytes);
  /// The next valid frame, or nothing when more bytes are needed. With `more_expected` false, a candidate that
  /// waits for bytes that will not come is given up, so that frames behind it are found.
  std::optional<Frame> next(bool more_expected = true);
  /// Forgets what was fed, keeps the counters.
  void clear();

  [[nodiscard]] std::uint32_t garbageBytes() const { return garbage_bytes_; }
  [[nodiscard]] std::uint32_t badChecksums() const { return bad_checksums_; }
  /// Bytes held that do not yet make a frame.
  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }

 private:
  void skip(std::size_t bytes);
  std::array<std::uint8_t, 2 * kMaxFrame> buffer_{};
  std::size_t begin_ = 0, end_ = 0;
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
