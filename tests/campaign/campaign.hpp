// The real cycle against the virtual robot in simulated time, with a wild controller, random faults and two judges: one
// reads the wire, one stands at the servos.
#pragma once

#include <memory>
#include <string>

#include "campaign/falling_body.hpp"
#include "campaign/servo_judge.hpp"
#include "campaign/wild_controller.hpp"
#include "campaign/wire_judge.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {

class Campaign : private hil::WireObserver {
 public:
  static constexpr Nanos kPeriod{16'000'000};

  /// Without a `board` the servos are alone on an adapter.
  explicit Campaign(std::uint64_t seed, std::unique_ptr<Body> body = std::make_unique<FallingBody>(),
                    bool board = true);

  void cycle(const Commands& asked);
  /// So many cycles under so many random faults a second; now and then all of them end, and the robot has to be driven
  /// again within seconds. Returns early when a promise was broken.
  void fight(long cycles, double faults_per_second, hil::FaultKinds kinds);

  [[nodiscard]] bool well() const;
  /// The first broken promise; empty: none.
  [[nodiscard]] std::string failure() const;

  hil::VirtualRobot robot;
  hil::MemoryLine line{robot};
  cm730::Cm730Bus bus{line, busConfig(robot.board().options().board)};
  safety::Config config{};
  safety::Guard guard{config};
  runtime::Cycle loop{bus, guard, kPeriod};
  WireJudge wire_judge{robot, kPeriod, config.max_joint_speed};
  ServoJudge servo_judge{robot, config};
  WildController controller;
  long cycles = 0, readings = 0, wrong = 0;
  long wrong_of_duplicates = 0;  // readings of an id that two servos have
  /// Readings that need not be right: on a line that damages bytes, some.
  [[nodiscard]] static double wrongReadingsAllowed(bool bytes_whole, long readings);
  /// What both judges and the campaign tolerated.
  [[nodiscard]] Tolerated tolerated() const;

 private:
  static cm730::BusConfig busConfig(bool board);
  void request(const Frame& frame, Nanos at) noexcept override;
  void reply(Bytes bytes, Nanos at) noexcept override;
  void checkReadings(const BodyState& before, const BodyState& after);
  void recover();

  Nanos release_{0};
  Tolerated tolerated_;
  std::string failure_;
};

/// All kinds, or those after which a reading is either right or missing.
[[nodiscard]] hil::FaultKinds allKinds();
[[nodiscard]] hil::FaultKinds kindsThatKeepBytesWhole();

}  // namespace darwinop
