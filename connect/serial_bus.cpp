#include "connect/serial_bus.hpp"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <stdexcept>

#include "connect/messages.hpp"
#include "connect/owned_bus.hpp"
#include "connect/start_pose_findings.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/host_checks.hpp"
#include "hal/cm730/diagnosis/port_check.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_port.hpp"
#include "hal/cm730/usb_serial.hpp"

namespace darwinop::connect {
namespace {

std::string problemText(const cm730::Findings& findings) {
  std::string text;
  for (const cm730::Finding& finding : findings)
    if (finding.level != cm730::Level::kOk) text += cm730::toText(finding);
  return text;
}

int servosFound(const cm730::RobotFacts& facts) {
  return static_cast<int>(std::ranges::count_if(facts.servo, &cm730::ServoFacts::readable));
}

/// ", absent: Neck, Head"; empty: none.
std::string names(const char* before, const std::bitset<kJoints>& joints) {
  std::string text;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (joints[i]) text.append(text.empty() ? before : ", ").append(kJointTable[i].name);
  return text;
}

std::string describe(const SerialRobot& robot, const cm730::RobotFacts& facts, const safety::Config& safety) {
  const std::string firmware = facts.board.absent ? std::string{} : " firmware " + std::to_string(facts.board.firmware);
  return robot.port + " (" + cm730::boardName(facts.board) + firmware + ", " + std::to_string(servosFound(facts)) +
         " servos" + names("; absent: ", safety.absent) + names("; not driven: ", safety.left_out) + ")";
}

cm730::ProbeOptions probeOptions(const SerialRobot& robot) {
  cm730::ProbeOptions options = cm730::ProbeOptions::quick();
  options.port = robot.port;
  options.period = robot.period;
  options.offsets = robot.offsets;
  options.absent = robot.safety.absent;
  options.permitted = robot.permitted;
  options.before_servo_power = robot.before_servo_power;
  options.allowed = goalTicks(robot.safety, robot.offsets);
  return options;
}

cm730::ProbeReport check(ByteLine& line, const SerialRobot& robot, cm730::Purpose purpose) {
  cm730::ProbeReport report = cm730::probe(line, probeOptions(robot));
  report.findings.push_back(cm730::clockRow(cm730::clockResolution()));
  std::ranges::move(cm730::latencyRows(robot.port, cm730::latencyTimer(robot.port)),
                    std::back_inserter(report.findings));
  const cm730::Policy policy = cm730::decide(report.findings, purpose);
  if (policy < cm730::Policy::kWait) return report;
  const std::string text = "the robot on " + robot.port + messages::kCannotBeDriven + problemText(report.findings) +
                           problemText(cm730::underTorqueRows(report.facts)) +
                           "Ask for the whole list with: darwinop doctor --robot " + robot.port;
  if (policy == cm730::Policy::kWait) throw cm730::NotReady(text);
  throw std::runtime_error(text);
}

/// Intersects the ranges with the servos' own angle limits. Joints with an empty range are not driven.
safety::Config withinServoLimits(const SerialRobot& robot, const cm730::ProbeReport& report, cm730::Purpose purpose) {
  safety::Config config = robot.safety;
  config.left_out |= cm730::leftOut(report.findings, purpose);
  config.no_writes |= cm730::noWrites(report.findings, purpose);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const cm730::ServoFacts& servo = report.facts.servo[i];
    if (!servo.readable || config.left_out[i]) continue;
    const auto joint = static_cast<Joint>(i);
    safety::JointRange& range = config.range[i];
    range.low = std::max(range.low, robot.offsets.jointAngle(joint, servo.cw_limit));
    range.high = std::min(range.high, robot.offsets.jointAngle(joint, servo.ccw_limit));
  }
  return config;
}

cm730::StallTorques stallTorques(const cm730::RobotFacts& facts) {
  cm730::StallTorques stall;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (const ServoModel* const model = findServoModel(facts.servo[i].model))
      stall.set(static_cast<Joint>(i), NewtonMeter{model->stall_torque});
  return stall;
}

}  // namespace

cm730::TickRanges goalTicks(const safety::Config& safety, const cm730::JointOffsets& offsets) {
  cm730::TickRanges ticks{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const auto clamped = [&](Rad goal) {
      return std::clamp<int>(offsets.servoTicks(joint, goal), row(joint).low, row(joint).high);
    };
    ticks[i] = {clamped(safety.range[i].low), clamped(safety.range[i].high)};
  }
  return ticks;
}

OpenedBus openSerialBus(const SerialRobot& robot, cm730::Purpose purpose) {
  if (robot.period < kShortestPeriod)
    throw std::runtime_error("a period of " + std::to_string(robot.period.count() / 1'000) +
                             " us is too short for the bus, where a cycle takes up to 5.5 ms; choose 8 ms or more");
  if (robot.period > kLongestPeriod)
    throw std::runtime_error("a period of " + std::to_string(robot.period.count() / 1'000'000) +
                             " ms is too long to protect a robot: a button or a servo that restarts would be seen too "
                             "late; choose 8 to 50 ms (16 is usual)");
  auto line = std::make_unique<cm730::SerialPort>(robot.port);
  const cm730::ProbeReport checked = check(*line, robot, purpose);
  OpenedBus opened;
  opened.safety = withinServoLimits(robot, checked, purpose);
  opened.description = describe(robot, checked.facts, opened.safety);
  opened.warnings = problemText(checked.findings) + problemText(startPoseFindings(checked.facts, opened.safety));
  cm730::BusConfig config = cm730::BusConfig::forPeriod(robot.period, robot.offsets);
  config.absent = robot.safety.absent;
  config.no_writes = opened.safety.no_writes;
  config.fixed_block_length = !checked.facts.instructions.all_blocks;
  config.stall = stallTorques(checked.facts);
  config.imu = cm730::ImuCorrection{robot.imu};
  config.board = !checked.facts.board.absent;
  opened.bus = std::make_unique<OwnedBus<cm730::SerialPort>>(std::move(line), config);
  return opened;
}

}  // namespace darwinop::connect
