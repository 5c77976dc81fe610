// A servo bus for unit tests of the loop: what each cycle reads is written down beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>

#include "hal/servo_bus.hpp"
#include "hil-mocks/script_failure.hpp"

namespace darwinop::hil {

/// Everything answers: board powered and upright, servos in the start pose, 11.8 V.
[[nodiscard]] BusReadings readingsAtRest();

///   ScriptedBus bus;
///   bus.cycles(10, readingsAtRest()).cycles(1, silent).expectWrite([](const SafeCommands& c) { ... });
/// A cycle is a write() and a read(). One cycle too many, a write or read out of turn, and cycles that were not
/// reached when the bus goes are failures.
class ScriptedBus : public ServoBus {
 public:
  using Check = std::function<void(const SafeCommands&)>;

  explicit ScriptedBus(ScriptFailure failure = abortOnScriptFailure) : failure_{std::move(failure)} {}
  ~ScriptedBus() override;
  ScriptedBus(const ScriptedBus&) = delete;
  ScriptedBus& operator=(const ScriptedBus&) = delete;

  /// The next `count` cycles read this.
  ScriptedBus& cycles(std::size_t count, const BusReadings& readings);
  /// Looks at what is written in the cycles added last.
  ScriptedBus& expectWrite(Check check);

  void write(const SafeCommands& commands) noexcept override;
  void read(BusReadings& readings) noexcept override;

  [[nodiscard]] std::size_t cyclesRun() const { return cycles_run_; }

 private:
  struct Step {
    std::size_t count;
    BusReadings readings;
    Check check;
  };

  ScriptFailure failure_;
  std::deque<Step> steps_;
  std::size_t cycles_run_ = 0;
  bool written_ = false;
};

}  // namespace darwinop::hil
