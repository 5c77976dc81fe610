// Encodings of servo registers: columns of a log that hold counts, as `load_raw`, with a declared encoding.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace darwinop::gap {

/// How a count has its sign.
enum class CountSign : std::uint8_t {
  kUnsigned,
  kBit10,             // 1024: negative, of Dynamixel protocol 1
  kBit15,             // 32768: negative, of Feetech
  kTwosComplement16,  // 65536 - n: -n, also where a program logged it unsigned
};

struct Encoding {
  std::string_view name;    // as a case.json declares it: "load_bit10"
  std::string_view column;  // without "_raw": "load"
  CountSign sign;
  double zero;   // count of the value 0
  double scale;  // SI units a count; load: share of the greatest duty
  std::string_view formula, source;

  /// Value in SI units; NaN for what a register of 16 bits cannot hold. A value without a reading, NaN, stays NaN.
  [[nodiscard]] double decode(double count) const;
};

std::span<const Encoding> encodings();
/// Null: there is none of that name.
const Encoding* findEncoding(std::string_view name);

}  // namespace darwinop::gap
