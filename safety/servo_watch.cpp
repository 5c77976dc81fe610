// What one servo tells about its health.
#include "safety/servo_watch.hpp"

#include "core/packet.hpp"

namespace darwinop::safety {
namespace {

using std::chrono::milliseconds;

constexpr double kHeatHysteresis = 5;          // deg C
constexpr Nanos kStartUp{milliseconds{1000}};  // servos start in about 0.3 s; the bus asks again twice a second

}  // namespace

void ServoWatch::update(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept {
  const bool heard = seen.motion.fresh();
  unheard_ = heard ? Nanos{0} : unheard_ + dt;
  silent_now_ = powered_for >= kStartUp && (lost() || given_up);
  if (heard) {
    const bool overheat = (seen.error_bits & error_bit::kOverheat) != 0;
    const bool voltage = (seen.error_bits & error_bit::kVoltage) != 0;
    overheat_bit_.update(overheat, !overheat);
    voltage_.update(voltage, !voltage, dt);
  }
  if (seen.health.fresh()) {  // NaN fails every comparison: unknown is no fault
    const double celsius = seen.temperature.value;
    hot_.update(celsius >= config_.hot, celsius <= config_.hot - kHeatHysteresis);
    overheated_.update(celsius >= config_.overheat, celsius <= config_.overheat - kHeatHysteresis);
  }
}

}  // namespace darwinop::safety
