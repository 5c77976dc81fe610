// Health of one servo: replies, temperature, supply voltage.
#pragma once

#include "core/packet.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class ServoWatch {
 public:
  explicit ServoWatch(const Config& config) : config_{config}, voltage_{kVoltageOn, kVoltageOff} {}

  /// Once a cycle. `given_up`: the bus has removed the servo from its read list for now. `powered_for`: time since
  /// servo power came on.
  void update(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept {
    const bool answers = seen.motion.fresh();
    silence_ = answers ? Nanos{0} : silence_ + dt;
    lost_ = !answers && silence_ >= fromSeconds(config_.silent_s);
    silent_now_ = powered_for >= kStartUp && (lost_ || given_up);
    if (answers) {
      const bool overheat = (seen.error_bits & error_bit::kOverheat) != 0;
      const bool voltage = (seen.error_bits & error_bit::kVoltage) != 0;
      overheat_bit_.update(overheat, !overheat);
      voltage_.update(voltage, !voltage, dt);
    }
    if (seen.polled.fresh()) {  // NaN fails every comparison: unknown is not a fault
      const double celsius = seen.temperature.value;
      hot_.update(celsius >= config_.hot, celsius <= config_.hot - kHeatHysteresis);
      overheated_.update(celsius >= config_.overheat, celsius <= config_.overheat - kHeatHysteresis);
    }
  }

  /// Silent for more than silent_s: it may have moved or restarted, so the last goal is not valid any more.
  [[nodiscard]] bool lost() const noexcept { return lost_; }
  /// Lost, or removed from the read list; never in the first second after power-up, while servos start.
  [[nodiscard]] bool silent() const noexcept { return silent_now_; }
  [[nodiscard]] bool hot() const noexcept { return hot_.on(); }
  [[nodiscard]] bool overheated() const noexcept { return (int{overheated_.on()} | overheat_bit_.on()) != 0; }
  [[nodiscard]] bool badVoltage() const noexcept { return voltage_.on(); }

 private:
  // Servos start in about 0.3 s; the bus retries a silent one every 16 cycles.
  static constexpr Nanos kStartUp{std::chrono::milliseconds{1000}};
  static constexpr Nanos kVoltageOn{std::chrono::milliseconds{100}}, kVoltageOff{std::chrono::milliseconds{1000}};

  const Config& config_;
  Nanos silence_{0};
  bool lost_ = false, silent_now_ = false;
  Confirm hot_, overheated_, overheat_bit_;
  Debounce voltage_;
};

}  // namespace darwinop::safety
