#include "hal/cm730/diagnosis/cycle_time.hpp"

#include <algorithm>
#include <cstddef>

#include "core/packet.hpp"
#include "hal/cm730/bus.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Nanos kDelayUnit{2'000};
constexpr std::size_t kSyncWriteBytes = 188;  // gains, goal, speed, torque limit of twenty servos
constexpr std::size_t kGoalBytes = 68;        // goals only, as in most cycles
constexpr std::size_t kRequestBytes = kFrameOverhead + 1 + 3 * (kJoints + 1);

constexpr std::size_t kReadBytes =
    kRequestBytes + kBoardWindow.frameBytes() + kServoPoll.frameBytes() + (kJoints - 1) * kServoWindow.frameBytes();
constexpr std::size_t kCycleBytes = kSyncWriteBytes + kReadBytes, kGoalCycleBytes = kGoalBytes + kReadBytes;

}  // namespace

Nanos returnDelays(const RobotFacts& facts) {
  Nanos sum{0};
  for (const ServoFacts& servo : facts.servo)
    if (servo.readable) sum += kDelayUnit * servo.return_delay;
  return sum;
}

Nanos usbTime(const RobotFacts& facts) {
  constexpr std::size_t kShortRead = 8 + 8;
  return std::max(Nanos{0}, facts.round_trip.median - wireTime(kShortRead));
}

Nanos cycleWireTime() {
  return wireTime(kCycleBytes);
}

Nanos cycleTime(const RobotFacts& facts) {
  return cycleWireTime() + returnDelays(facts) + usbTime(facts);
}

bool cycleFits(const RobotFacts& facts) {
  const Nanos besides_bytes = returnDelays(facts) + usbTime(facts);
  return usbTime(facts) <= BusConfig::forPeriod(facts.period).margin &&
         wireTime(kGoalCycleBytes) + besides_bytes <= facts.period - kHeadroom &&
         cycleWireTime() + besides_bytes <= facts.period;
}

}  // namespace darwinop::cm730
