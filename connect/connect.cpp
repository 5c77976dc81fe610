#include "connect/connect.hpp"

#include <algorithm>
#include <bitset>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "connect/daemon_warnings.hpp"
#include "connect/lockstep_robot.hpp"
#include "connect/owned_bus.hpp"
#include "connect/robot_file.hpp"
#include "connect/setting.hpp"
#include "connect/start_pose_findings.hpp"
#include "connect/twin_library.hpp"
#include "hal/cm730/diagnosis/host_checks.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_port.hpp"
#ifdef DARWINOP_WITH_REMOTE_CLIENT
#include "remote/client/tcp_link.hpp"
#endif
#include "runtime/daemon_link.hpp"
#include "runtime/threaded_link.hpp"
#include "safety/layers.hpp"

namespace darwinop::connect {
namespace {

constexpr Nanos kShortestPeriod{8'000'000};

void warn(const ConnectRequest& request, const std::string& lines) {
  if (!request.warn) {
    std::cerr << lines;
    return;
  }
  constexpr std::string_view kSpeaker = "darwinop: ";  // the receiver adds its own program name
  std::istringstream rest{lines};
  for (std::string line; std::getline(rest, line);)
    request.warn(line.starts_with(kSpeaker) ? line.substr(kSpeaker.size()) : line);
}

runtime::LoopConfig loopConfig(const ConnectRequest& request) {
  runtime::LoopConfig config;
  config.period = request.period.value_or(kUsualPeriod);
  config.safety = request.safety;
  config.robot = request.robot_name;
  config.record_path = request.record_path;
  config.record_notes = request.record_notes;
  return config;
}

std::unique_ptr<runtime::RobotLink> serialRobot(const ConnectRequest& request, const std::string& port) {
  const RobotFile robot = readRobotFile();
  runtime::LoopConfig config = loopConfig(request);
  config.period = request.period.value_or(robot.period.value_or(kUsualPeriod));
  config.safety = safetyOn(robot, request.safety, request.config_file);
  config.real_time.demand = runtime::realTimeFromEnvironment();
  OpenedBus opened = openSerialBus({port, config.period, config.safety, robot.offsets});
  config.safety = opened.safety;
  config.port = opened.description;
  warn(request, opened.warnings);
  auto link = std::make_unique<runtime::ThreadedLink>(config, std::move(opened.bus));
  if (!link->warning().empty()) warn(request, "darwinop: " + link->warning() + "\n");
  return link;
}

std::unique_ptr<runtime::RobotLink> daemonsRobot(const ConnectRequest& request) {
  auto link = std::make_unique<runtime::DaemonLink>();
  warn(request, daemonWarnings(request, link->period()));
  if (asksForSafety(request.safety))
    link->setSafety(safety::layered({link->robotSafety(), "the runtime"}, {request.safety, request.config_file}));
  return link;
}

std::unique_ptr<runtime::RobotLink> virtualRobot(const ConnectRequest& request) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = "virtual robot in memory";
  return lockstepRobot(config);
}

std::unique_ptr<runtime::RobotLink> twin(const ConnectRequest& request, const std::string& model) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = "twin in memory, model " + (model.empty() ? kUsualTwin : model);
  return lockstepRobot(config, makeTwin(model, twinSeed()));
}

#ifdef DARWINOP_WITH_REMOTE_CLIENT
std::unique_ptr<runtime::RobotLink> robotOverTcp(const ConnectRequest& request, const Address& server) {
  // The protocol cannot transmit them, and ignoring a requested limit silently would be unsafe.
  if (asksForSafety(request.safety))
    throw std::runtime_error(request.config_file +
                             ": [Safety] and [Limits] do not reach a robot over TCP. Remove them "
                             "here and put them into robot.ini on the robot, where they hold for every controller");
  remote::TcpOptions options;
  options.host = server.host;
  options.port = server.port;
  options.log = [](const std::string& what) { std::cerr << "darwinop: " << what << std::endl; };
  auto link = std::make_unique<remote::TcpLink>(std::move(options));
  warn(request, tcpWarnings(request, link->period()));
  return link;
}
#else
std::unique_ptr<runtime::RobotLink> robotOverTcp(const ConnectRequest&, const Address& server) {
  throw std::runtime_error("tcp://" + server.host +
                           ": programs built for the robot drive the robot that they run on. Build this controller for "
                           "the PC and start it there");
}
#endif

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
  return robot.port + " (CM-730 firmware " + std::to_string(facts.board.firmware) + ", " +
         std::to_string(servosFound(facts)) + " servos" + names("; absent: ", safety.absent) +
         names("; not driven: ", safety.left_out) + ")";
}

cm730::ProbeOptions probeOptions(const SerialRobot& robot) {
  cm730::ProbeOptions options = cm730::ProbeOptions::quick();
  options.port = robot.port;
  options.period = robot.period;
  options.offsets = robot.offsets;
  options.absent = robot.safety.absent;
  options.allowed = goalTicks(robot.safety, robot.offsets);
  return options;
}

/// Servos keep their torque across a restart of the computer, and no loop monitors them if this one does not start.
std::string stiffServos(const cm730::RobotFacts& facts) {
  const auto stiff = std::ranges::count_if(facts.servo, [](const auto& s) { return s.readable && s.torque_on; });
  if (stiff == 0) return {};
  return std::to_string(stiff) +
         " servos hold their joints, and nothing watches them: hold the robot and press RESET on its back (all servos "
         "go limp)\n";
}

cm730::ProbeReport check(ByteLine& line, const SerialRobot& robot, cm730::Purpose purpose) {
  cm730::ProbeReport report = cm730::probe(line, probeOptions(robot));
  report.findings.push_back(cm730::clockRow(cm730::clockResolution()));
  const cm730::Policy policy = cm730::decide(report.findings, purpose);
  if (policy < cm730::Policy::kWait) return report;
  const std::string text = "the robot on " + robot.port + " cannot be driven:\n" + problemText(report.findings) +
                           stiffServos(report.facts) + "Ask for the whole list with: darwinop doctor --robot " +
                           robot.port;
  if (policy == cm730::Policy::kWait) throw cm730::NotReady(text);
  throw std::runtime_error(text);
}

/// Intersects the ranges with the servos' own angle limits. Joints with an empty range are not driven.
safety::Config withinServoLimits(const SerialRobot& robot, const cm730::ProbeReport& report, cm730::Purpose purpose) {
  safety::Config config = robot.safety;
  config.left_out |= cm730::leftOut(report.findings, purpose);
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
  auto line = std::make_unique<cm730::SerialPort>(robot.port);
  const cm730::ProbeReport checked = check(*line, robot, purpose);
  OpenedBus opened;
  opened.safety = withinServoLimits(robot, checked, purpose);
  opened.description = describe(robot, checked.facts, opened.safety);
  opened.warnings = problemText(checked.findings) + problemText(startPoseFindings(checked.facts));
  cm730::BusConfig config = cm730::BusConfig::forPeriod(robot.period, robot.offsets);
  config.absent = robot.safety.absent;
  config.fixed_block_length = !checked.facts.instructions.all_blocks;
  opened.bus = std::make_unique<OwnedBus<cm730::SerialPort>>(std::move(line), config);
  return opened;
}

std::unique_ptr<runtime::RobotLink> connect(const ConnectRequest& request) {
  const Setting setting = readSetting(request.setting);
  switch (setting.kind) {
    case RobotKind::kDaemon:
      return daemonsRobot(request);
    case RobotKind::kSerial:
      return serialRobot(request, setting.port);
    case RobotKind::kVirtual:
      return virtualRobot(request);
    case RobotKind::kTwin:
      return twin(request, setting.model);
    case RobotKind::kTcp:
      return robotOverTcp(request, setting.server);
  }
  throw std::logic_error("a kind of robot that connect() does not know");
}

}  // namespace darwinop::connect
