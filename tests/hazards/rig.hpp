// The whole chain from controller image to servo registers, in memory: what a hazard's reaction is measured on.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <utility>

#include "core/commands.hpp"
#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {

/// Passes bytes on, but for the frames that `lost` names, and a status that it damages.
class LosingLine final : public ByteLine {
 public:
  explicit LosingLine(ByteLine& inner) : inner_{inner} {}
  std::function<bool(Bytes)> lost;

  [[nodiscard]] Nanos now() noexcept override { return inner_.now(); }
  LineStatus write(Bytes bytes) noexcept override {
    return lost && lost(bytes) ? LineStatus::kOk : inner_.write(bytes);
  }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    const LineStatus status = inner_.read(into, count, deadline);
    if (status == LineStatus::kOk) damage(into.first(count));
    return status;
  }
  /// The error byte of this servo's next status has these bits too, and its checksum fits.
  void damageNext(Joint joint, std::uint8_t error_bits) {
    damaged_id_ = row(joint).id;
    error_bits_ = error_bits;
  }
  void discardInput() noexcept override { inner_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return inner_.reconnects(); }

 private:
  void damage(std::span<std::uint8_t> bytes) {
    for (std::size_t at = 0; error_bits_ != 0 && at + kFrameOverhead <= bytes.size(); ++at) {
      const auto frame = bytes.subspan(at);
      if (frame[0] != 0xFF || frame[1] != 0xFF || frame[2] != damaged_id_) continue;
      const std::size_t body = frame[3] + std::size_t{1};  // id, length, error, parameters
      if (frame.size() < 2 + body + 1) continue;
      frame[4] |= std::exchange(error_bits_, std::uint8_t{0});
      frame[2 + body] = checksum(frame.subspan(2, body));
    }
  }

  ByteLine& inner_;
  std::uint8_t damaged_id_ = 0, error_bits_ = 0;
};

/// Judged by the registers of the virtual servos and by the body, never by what the safety layer says of itself.
struct HazardRig {
  static constexpr Nanos kPeriod{16'000'000};
  static constexpr long kLimit = 2000;  // cycles, 32 s: longer than any reaction

  explicit HazardRig(const hil::BoardOptions& options = {}, std::unique_ptr<Body> body = nullptr)
      : robot{options, 1, std::move(body)} {
    commands.session = 1;
    commands.start_where_it_is = true;
  }

  void cycle() {
    release += kPeriod;
    line.advanceTo(release);
    if (controller_steps) ++commands.sequence;
    loop.run(commands, {.release = release});
  }
  void run(long cycles) {
    for (long i = 0; i < cycles; ++i) cycle();
  }
  /// Cycles until `done` holds, at most kLimit; kLimit + 1 and a failure when it never does.
  long cyclesUntil(const std::function<bool()>& done) {
    for (long i = 0; i <= kLimit; ++i) {
      if (done()) return i;
      cycle();
    }
    ADD_FAILURE() << "no reaction within " << kLimit << " cycles";
    return kLimit + 1;
  }
  /// A controller drives every joint. Each has caught up with its goal, so that nothing but limits makes it slow.
  void drive() {
    cyclesUntil([this] { return state() == State::kDriven && torqueCount() == kJoints; });
    for (std::size_t i = 0; i < kJoints; ++i) commands.joint[i].setGoal(radFromTicks(goal(static_cast<Joint>(i))));
    run(60);
  }
  /// From now on, at every joint that the kind concerns.
  void fault(hil::FaultKind kind, double amount = 0, Nanos lasts = hil::InjectedFault::kForEver) {
    hil::InjectedFault fault;
    fault.kind = kind;
    fault.at = line.now();
    fault.lasts = lasts;
    fault.amount = amount;
    fault.joints.set();
    robot.faults().add(fault);
  }
  void faultAt(Joint joint, hil::FaultKind kind, Nanos lasts = hil::InjectedFault::kForEver, std::uint8_t bits = 0) {
    hil::InjectedFault fault;
    fault.kind = kind;
    fault.at = line.now();
    fault.lasts = lasts;
    fault.joints.set(index(joint));
    fault.bits = bits;
    robot.faults().add(fault);
  }
  /// Writes a servo's registers behind the loop's back, between two cycles.
  void poke(Joint joint, std::uint8_t address, std::initializer_list<std::uint8_t> data) {
    std::array<std::uint8_t, kMaxFrame> frame{};
    line.write(encodeWrite(frame, row(joint).id, address, Bytes{data.begin(), data.size()}));
    line.advanceTo(line.now() + Nanos{1'000'000});
  }
  [[nodiscard]] JointCommand& joint(Joint which) { return commands.joint[index(which)]; }

  [[nodiscard]] const Sensors& seen() const { return loop.sensors(); }
  [[nodiscard]] State state() const { return seen().safety.state; }
  [[nodiscard]] bool active(Fault fault) const { return seen().safety.active[safety::rowIndex(fault)]; }
  [[nodiscard]] const hil::ControlTable& registers(Joint joint) const { return robot.board().servo(joint).table(); }
  /// The servo has supply and holds its joint.
  [[nodiscard]] bool torque(Joint joint) const {
    return robot.board().servo(joint).listens(robot.now()) && registers(joint).byte(servo::kTorqueEnable) != 0;
  }
  [[nodiscard]] int position(Joint joint) const { return registers(joint).word(servo::kPresentPosition); }
  [[nodiscard]] int goal(Joint joint) const { return registers(joint).word(servo::kGoalPosition); }
  [[nodiscard]] std::size_t torqueCount() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kJoints; ++i) count += torque(static_cast<Joint>(i)) ? 1 : 0;
    return count;
  }

  static cm730::BusConfig busConfig(bool board) {
    cm730::BusConfig config = cm730::BusConfig::forPeriod(kPeriod);
    config.board = board;
    return config;
  }

  hil::VirtualRobot robot;
  hil::MemoryLine line{robot};
  LosingLine losing{line};
  cm730::Cm730Bus bus{losing, busConfig(robot.board().options().board)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle loop{bus, guard, kPeriod};
  Commands commands{};
  bool controller_steps = true;
  Nanos release{0};
};

}  // namespace darwinop
