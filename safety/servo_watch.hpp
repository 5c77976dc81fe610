// What one servo tells about its health: does it answer, is it warm, is its supply good?
#pragma once

#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class ServoWatch {
 public:
  explicit ServoWatch(const Config& config) : config_{config}, voltage_{kVoltageOn, kVoltageOff} {}

  /// `given_up`: the bus has taken the servo off its list for now. `powered_for`: how long servos have had power.
  void update(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept;

  /// Not heard for so long that the last goal must not be trusted any more: it may have moved or restarted.
  [[nodiscard]] bool lost() const noexcept { return unheard_ >= fromSeconds(config_.silent_s); }
  /// Lost, or given up by the bus; never in the second after power came on, in which servos start.
  [[nodiscard]] bool silent() const noexcept { return silent_now_; }
  [[nodiscard]] bool hot() const noexcept { return hot_.on(); }
  [[nodiscard]] bool overheated() const noexcept { return overheated_.on() || overheat_bit_.on(); }
  [[nodiscard]] bool badVoltage() const noexcept { return voltage_.on(); }

 private:
  static constexpr Nanos kVoltageOn{std::chrono::milliseconds{100}}, kVoltageOff{std::chrono::milliseconds{1000}};

  const Config& config_;
  Nanos unheard_{0};
  bool silent_now_ = false;
  Confirm hot_, overheated_, overheat_bit_;
  Debounce voltage_;
};

}  // namespace darwinop::safety
