// The table of encodings.
#include "gap/case/encodings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/servo_limits.hpp"
#include "core/units.hpp"

namespace darwinop::gap {
namespace {

constexpr double kTick = kRadPerTick, kRpm = kRadPerSecPerRpm;
constexpr std::string_view kMx = "e-manual MX-28, protocol 1", kX = "e-manual X series, protocol 2",
                           kAx = "e-manual AX-12A and RX-28", kSts = "Feetech memory table STS3215";

constexpr auto kEncodings = std::to_array<Encoding>({
    {"position_4096", "pos", CountSign::kUnsigned, 2048, kTick, "(n - 2048) 2 pi / 4096 rad", kMx},
    {"position_4096_signed", "pos", CountSign::kTwosComplement16, 2048, kTick,
     "(n - 2048) 2 pi / 4096 rad, n < 0 below 0", kX},
    {"goal_4096", "goal", CountSign::kUnsigned, 2048, kTick, "(n - 2048) 2 pi / 4096 rad", kMx},
    {"load_bit10", "load", CountSign::kBit10, 0, 1e-3, "0.1 % a count, bit 10: clockwise, negative", kMx},
    {"load_int16", "load", CountSign::kTwosComplement16, 0, 1e-3, "0.1 % a count, 16 bits in two's complement", kX},
    {"load_bit10_1023", "load", CountSign::kBit10, 0, 1.0 / 1023, "n / 1023, bit 10: clockwise, negative", kAx},
    {"pwm_int16_885", "load", CountSign::kTwosComplement16, 0, 1.0 / 885, "n / 885, 16 bits in two's complement", kX},
    {"speed_bit10_0.114rpm", "speed", CountSign::kBit10, 0, 0.114 * kRpm, "0.114 rpm a count, bit 10: negative", kMx},
    {"speed_bit10_0.111rpm", "speed", CountSign::kBit10, 0, 0.111 * kRpm, "0.111 rpm a count, bit 10: negative", kAx},
    {"speed_int16_0.229rpm", "speed", CountSign::kTwosComplement16, 0, 0.229 * kRpm, "0.229 rpm a count", kX},
    {"speed_bit15_0.732rpm", "speed", CountSign::kBit15, 0, 0.732 * kRpm, "0.732 rpm a count, bit 15: negative", kSts},
    {"speed_bit15_50steps", "speed", CountSign::kBit15, 0, 50 * kTick, "50 steps/s a count, bit 15: negative", kSts},
    {"speed_bit15_steps", "speed", CountSign::kBit15, 0, kTick, "1 step/s a count, bit 15: negative", kSts},
    {"current_int16_2.69mA", "current", CountSign::kTwosComplement16, 0, 2.69e-3, "2.69 mA a count", kX},
    {"current_bit15_6.5mA", "current", CountSign::kBit15, 0, 6.5e-3, "6.5 mA a count, bit 15: negative", kSts},
    {"volt_0.1V", "volt", CountSign::kUnsigned, 0, 0.1, "0.1 V a count", kMx},
    {"temp_1C", "temp", CountSign::kUnsigned, 0, 1, "1 degC a count", kMx},
});

}  // namespace

double Encoding::decode(double count) const {
  constexpr double kBad = std::numeric_limits<double>::quiet_NaN();
  // A program may have applied the sign before it logged the count.
  if (!(count >= -32'768 && count <= 65'535) || count != std::nearbyint(count)) return kBad;
  if (count < 0 && sign == CountSign::kUnsigned) return kBad;
  double value = count;
  if (sign == CountSign::kBit10 && count >= 1'024) value = count < 2'048 ? 1'024 - count : kBad;
  if (sign == CountSign::kBit15 && count >= 32'768) value = 32'768 - count;
  if (sign == CountSign::kTwosComplement16 && count >= 32'768) value = count - 65'536;
  return (value - zero) * scale;
}

std::span<const Encoding> encodings() {
  return kEncodings;
}

const Encoding* findEncoding(std::string_view name) {
  const auto found = std::ranges::find(kEncodings, name, &Encoding::name);
  return found == kEncodings.end() ? nullptr : &*found;
}

}  // namespace darwinop::gap
