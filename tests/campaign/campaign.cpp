#include "campaign/campaign.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop {
namespace {

using hil::FaultKind;

constexpr long kPeaceEvery = 5000;  // cycles
constexpr auto kRecoveryCycles = boundAs<int>(Leniency::kRecovery);

double seconds(Nanos time) {
  return std::chrono::duration<double>(time).count();
}

/// A servo that gets its supply back needs a while to start, like a real one.
hil::BoardOptions slowStarters(bool board) {
  hil::BoardOptions options;
  options.board = board;
  options.servo_boot = Nanos{200'000'000};
  return options;
}

hil::InjectedFault randomFaults(double per_second, hil::FaultKinds kinds) {
  hil::InjectedFault fault;
  fault.kind = FaultKind::kRandom;
  fault.amount = per_second;
  fault.kinds = kinds;
  return fault;
}

}  // namespace

hil::FaultKinds allKinds() {
  return ~hil::FaultKinds{};
}

hil::FaultKinds kindsThatKeepBytesWhole() {
  hil::FaultKinds kinds = allKinds();
  for (const FaultKind kind : {FaultKind::kDrop, FaultKind::kCorrupt, FaultKind::kRepeat, FaultKind::kGarbage,
                               FaultKind::kBabble, FaultKind::kTwins, FaultKind::kNoise})
    kinds.reset(static_cast<std::size_t>(kind));
  return kinds;
}

cm730::BusConfig Campaign::busConfig(bool board) {
  cm730::BusConfig config = cm730::BusConfig::forPeriod(kPeriod);
  config.board = board;
  return config;
}

Campaign::Campaign(std::uint64_t seed, std::unique_ptr<Body> body, bool board)
    : robot{slowStarters(board), seed, std::move(body)}, controller{seed} {
  line.observe(this);
}

void Campaign::request(const Frame& frame, Nanos at) noexcept {
  wire_judge.request(frame, at);
  servo_judge.request(frame, at);
}

void Campaign::reply(Bytes bytes, Nanos at) noexcept {
  wire_judge.reply(bytes, at);
  servo_judge.reply(bytes, at);
}

void Campaign::cycle(const Commands& asked) {
  ++cycles;
  release_ += kPeriod;
  line.advanceTo(release_);
  wire_judge.beginCycle();
  servo_judge.beginCycle(asked);
  const BodyState before = robot.body().state();
  loop.run(asked, {.release = release_, .wake_latency = line.now() - release_});
  wire_judge.endCycle(loop.sensors());
  servo_judge.endCycle(loop.sensors());
  checkReadings(before, robot.body().state());
}

/// A value that says it is fresh must lie where the joint was during this very cycle. Two servos with one id answer at
/// the same time, and the mixture of two frames that do not change may have the same valid checksum again and again: no
/// reader can detect it, so these readings are counted apart.
void Campaign::checkReadings(const BodyState& before, const BodyState& after) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = loop.sensors().joint[i];
    if (!joint.motion.fresh()) continue;
    ++readings;
    const JointMotion &then = before.joint[i], &now = after.joint[i];
    const auto [low, high] = std::minmax(then.position_rad, now.position_rad);
    // A joint that turned back within the cycle was further out in between than at both ends.
    const double speed = std::max(std::abs(then.velocity_rad_s), std::abs(now.velocity_rad_s));
    const double turn = then.velocity_rad_s * now.velocity_rad_s < 0 ? speed * seconds(kPeriod) / 2 : 0;
    const double off = std::max(low - joint.position.value, joint.position.value - high) - turn;
    if (off <= 0) continue;
    if (off <= bound(Leniency::kReadingSlack) * kRadPerTick) {
      tolerated_.note(Leniency::kReadingSlack);
      continue;
    }
    const bool twin = robot.board().hasTwin(static_cast<Joint>(i));
    ++(twin ? wrong_of_duplicates : wrong);
    tolerated_.note(twin ? Leniency::kTwinReadings : Leniency::kWrongReadings);
  }
}

double Campaign::wrongReadingsAllowed(bool bytes_whole, long readings) {
  return bytes_whole ? 0 : 1 + bound(Leniency::kWrongReadings) * static_cast<double>(readings);
}

Tolerated Campaign::tolerated() const {
  Tolerated all = tolerated_;
  all += servo_judge.tally().tolerated;
  return all += wire_judge.tolerated();
}

bool Campaign::well() const {
  const Sensors& s = loop.sensors();
  return s.safety.state == State::kDriven && s.bus.fresh() &&
         std::ranges::all_of(s.joint, [](const auto& j) { return j.motion.fresh() && j.driven; });
}

std::string Campaign::failure() const {
  if (!servo_judge.failure().empty()) return "at a servo, " + servo_judge.failure();
  if (!wire_judge.failure().empty()) return "on the wire: " + wire_judge.failure();
  return failure_;
}

void Campaign::fight(long count, double faults_per_second, hil::FaultKinds kinds) {
  robot.faults().add(randomFaults(faults_per_second, kinds));
  for (long i = 0; i < count && failure().empty(); ++i) {
    cycle(controller.next());
    if (i % kPeaceEvery != kPeaceEvery - 1) continue;
    robot.faults().clear();
    recover();
    robot.faults().add(randomFaults(faults_per_second, kinds));
  }
}

void Campaign::recover() {
  for (int i = 0; i < kRecoveryCycles; ++i) {
    if (well()) break;
    if (i == 0) tolerated_.note(Leniency::kRecovery);
    cycle(controller.calm());
  }
  if (well()) return;
  const SafetyReport& report = loop.sensors().safety;
  failure_ = "cycle " + std::to_string(cycles) + ": not driven again after " + std::to_string(kRecoveryCycles) +
             " cycles without faults; state " + std::string{kStateNames[static_cast<std::size_t>(report.state)]} +
             ", worst fault " + std::string{row(report.worst).name};
}

}  // namespace darwinop
