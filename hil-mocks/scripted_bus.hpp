// Scripted servo bus for unit tests of the loop: the readings of each cycle are given in advance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>

#include "hal/servo_bus.hpp"
#include "hil-mocks/script_failure.hpp"

namespace darwinop::hil {

/// Normal readings: board powered and upright, servos in the start pose, 11.8 V.
[[nodiscard]] BusReadings readingsAtRest();

///   ScriptedBus bus;
///   bus.cycles(10, readingsAtRest()).cycles(1, silent).expectWrite([](const SafeCommands& c) { ... });
/// A cycle is a write() and a read(). Failures: a cycle after the script, a write or read out of turn, and cycles not
/// reached at destruction.
class ScriptedBus : public ServoBus {
 public:
  using Check = std::function<void(const SafeCommands&)>;

  explicit ScriptedBus(ScriptFailure failure = abortOnScriptFailure) : failure_{std::move(failure)} {}
  ~ScriptedBus() override;
  ScriptedBus(const ScriptedBus&) = delete;
  ScriptedBus& operator=(const ScriptedBus&) = delete;

  /// Readings of the next `count` cycles.
  ScriptedBus& cycles(std::size_t count, const BusReadings& readings);
  /// Checks what is written in the cycles added last.
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
