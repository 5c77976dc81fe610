#include "hal/cm730/diagnosis/drawn_robot.hpp"

#include <memory>

#include "core/conversions.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

/// Holds with a constant load while it is under torque, as legs that carry a robot do.
class LoadedBody final : public hil::PlainBody {
 public:
  explicit LoadedBody(double load) : load_{load} {}
  void step(Nanos dt, const Drives& drives) noexcept override {
    PlainBody::step(dt, drives);
    for (std::size_t i = 0; i < kJoints; ++i)
      if (drives[i].torque_on) motion(static_cast<Joint>(i)).load = load_;
  }

 private:
  double load_;
};

/// The bridge with a drawn delay, noise, and another program that has the port open.
class FaultyBridge final : public BridgedLine {
 public:
  FaultyBridge(hil::MemoryLine& line, const RobotDraw& drawn, std::uint64_t seed)
      : BridgedLine{line, drawn.latency, 1ms}, drawn_{drawn}, rng_{seed}, next_{drawn.other_period} {}

 protected:
  [[nodiscard]] Nanos nextEvent() const override { return next_ == 0ns ? Nanos::max() : next_; }
  void happen(hil::MemoryLine& line) override {
    std::array<std::uint8_t, kMaxFrame> frame{};
    BulkReadEncoder request{frame};
    request.add(kBoardId, kBoardWindow.address, kBoardWindow.count);
    for (std::size_t i = 0; i < kJoints; ++i) request.add(servoId(i), kServoWindow.address, kServoWindow.count);
    line.write(request.finish());
    next_ += drawn_.other_period;
  }
  void spoil(std::span<std::uint8_t> bytes) override {
    for (std::uint8_t& byte : bytes)
      if (drawn_.damaged_per_byte > 0 && rng_.uniform() < drawn_.damaged_per_byte)
        byte ^= static_cast<std::uint8_t>(1U << rng_.below(8));
  }
  // Each block of bytes goes to whichever program reads first.
  bool arrives() override { return drawn_.other_period == 0ns || rng_.coin(); }
  Nanos delay() override {
    const auto range = static_cast<double>((drawn_.most_delay - drawn_.least_delay).count());
    return drawn_.least_delay + Nanos{static_cast<std::int64_t>(range * rng_.uniform())};
  }

 private:
  const RobotDraw& drawn_;
  Rng rng_;
  Nanos next_;
};

std::unique_ptr<hil::PlainBody> bodyOf(const RobotDraw& drawn) {
  auto body = std::make_unique<LoadedBody>(drawn.load);
  for (std::size_t i = 0; i < kJoints; ++i) body->place(static_cast<Joint>(i), drawn.position_rad[i]);
  return body;
}

void switchTorqueOn(hil::MemoryLine& line) {
  const std::uint8_t on = 1;
  for (std::size_t i = 0; i < kJoints; ++i) writeRegisters(line, servoId(i), servo::kTorqueEnable, Bytes{&on, 1});
}

}  // namespace

RobotDraw drawHealthy(Rng& rng) {
  RobotDraw drawn;
  drawn.board.supply_v = rng.between(11.1, 12.6);
  drawn.board.temperature_c = rng.between(15, 45);
  drawn.board.servo_boot = hil::faultTime(rng.between(0, 0.2));
  drawn.torque_on = rng.below(4) == 0;
  drawn.board.servo_power = drawn.torque_on || rng.coin();
  drawn.load = rng.between(0, 0.2);
  drawn.most_delay = hil::faultTime(rng.between(0, 0.0008));
  const bool any_pose = rng.below(3) == 0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointRow& joint = kJointTable[i];
    drawn.board.servo[i].return_delay = static_cast<std::uint8_t>(rng.below(6));
    drawn.position_rad[i] = any_pose ? rng.between(radFromTicks(joint.low).value, radFromTicks(joint.high).value)
                                     : radFromTicks(joint.start).value + rng.between(-0.1, 0.1);
    hil::InjectedFault warm;
    warm.kind = hil::FaultKind::kHeat;
    warm.joints.set(i);
    warm.amount = drawn.board.temperature_c + rng.between(0, 19);
    drawn.script.push_back(warm);
  }
  return drawn;
}

RobotDraw drawFault(const DrawnFault& fault, Rng& rng) {
  RobotDraw drawn = drawHealthy(rng);
  drawn.fault = fault.named;
  fault.draw(drawn, rng);
  return drawn;
}

DoctorResult examine(const RobotDraw& drawn, std::uint64_t seed) {
  hil::VirtualRobot robot{drawn.board, seed, bodyOf(drawn)};
  hil::MemoryLine memory{robot};
  if (drawn.torque_on) switchTorqueOn(memory);
  const Nanos begin = memory.now();
  for (hil::InjectedFault fault : drawn.script) {
    fault.at += begin;
    robot.faults().add(fault);
  }
  FaultyBridge line{memory, drawn, seed};
  line.advanceTo(begin);
  DoctorResult result{probe(line, ProbeOptions::thorough()), {}};
  result.named = nameFaults(result.report.facts, result.report.findings);
  return result;
}

}  // namespace darwinop::cm730
