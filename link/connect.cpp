#include "link/connect.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "hal/cm730/diagnosis.hpp"
#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/probe.hpp"
#include "hal/cm730/serial_port.hpp"
#include "link/daemon_warnings.hpp"
#include "link/lockstep_robot.hpp"
#include "link/owned_bus.hpp"
#include "link/robot_file.hpp"
#include "link/setting.hpp"
#include "link/start_pose_findings.hpp"
#include "link/twin_library.hpp"
#ifdef DARWINOP_REMOTE_CLIENT
#include "remote/client/tcp_link.hpp"
#endif
#include "runtime/daemon_link.hpp"
#include "runtime/threaded_link.hpp"

namespace darwinop::link {
namespace {

constexpr Nanos kShortestPeriod{8'000'000};
constexpr Nanos kSpare{1'000'000};  // of a period, for what is no bus time

runtime::LoopConfig loopConfig(const Request& request) {
  runtime::LoopConfig config;
  config.period = request.period.value_or(kUsualPeriod);
  config.safety = request.safety;
  config.robot = request.robot_name;
  config.record_path = request.record_path;
  config.record_notes = request.record_notes;
  return config;
}

std::unique_ptr<runtime::RobotLink> serialRobot(const Request& request, const std::string& port) {
  const RobotFile robot = readRobotFile();
  runtime::LoopConfig config = loopConfig(request);
  config.period = request.period.value_or(robot.period.value_or(kUsualPeriod));
  config.safety = safetyOn(robot, request.safety, request.config_file);
  config.real_time.demand = runtime::realTimeFromEnvironment();
  OpenedBus opened = openSerialBus(port, config.period, robot.offsets);
  config.port = opened.description;
  if (!opened.warnings.empty()) std::cerr << opened.warnings;
  auto link = std::make_unique<runtime::ThreadedLink>(config, std::move(opened.bus));
  if (!link->warning().empty()) std::cerr << "darwinop: " << link->warning() << '\n';
  return link;
}

std::unique_ptr<runtime::RobotLink> daemonsRobot(const Request& request) {
  auto link = std::make_unique<runtime::DaemonLink>();
  std::cerr << daemonWarnings(request, link->period());
  return link;
}

std::unique_ptr<runtime::RobotLink> virtualRobot(const Request& request) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = "virtual robot in memory";
  return lockstepRobot(config);
}

std::unique_ptr<runtime::RobotLink> twin(const Request& request, const std::string& model) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = "twin in memory, model " + (model.empty() ? kUsualTwin : model);
  return lockstepRobot(config, makeTwin(model, twinSeed()));
}

#ifdef DARWINOP_REMOTE_CLIENT
std::unique_ptr<runtime::RobotLink> robotOverTcp(const Request& request, const Address& server) {
  remote::TcpOptions options;
  options.host = server.host;
  options.port = server.port;
  options.say = [](const std::string& what) { std::cerr << "darwinop: " << what << std::endl; };
  auto link = std::make_unique<remote::TcpLink>(std::move(options));
  std::cerr << tcpWarnings(request, link->period());
  return link;
}
#else
std::unique_ptr<runtime::RobotLink> robotOverTcp(const Request&, const Address& server) {
  throw std::runtime_error("tcp://" + server.host +
                           ": programs built for the robot drive the robot that they run on. Build this controller for "
                           "the PC and start it there");
}
#endif

std::string inMs(Nanos time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", std::chrono::duration<double, std::milli>(time).count());
  return text;
}

std::string troubles(const cm730::Findings& findings) {
  std::string text;
  for (const cm730::Finding& finding : findings)
    if (finding.level != cm730::Level::kOk) text += cm730::toText(finding);
  return text;
}

int servosFound(const cm730::RobotFacts& facts) {
  return static_cast<int>(std::ranges::count_if(facts.servo, &cm730::ServoFacts::readable));
}

std::string describe(const std::string& port, const cm730::RobotFacts& facts) {
  return port + " (CM-730 firmware " + std::to_string(facts.board.firmware) + ", " +
         std::to_string(servosFound(facts)) + " servos)";
}

/// A robot that lacks a few servos can be driven without them; one that cannot be understood cannot.
cm730::ProbeReport lookAt(ByteLine& line, const std::string& port, Nanos period, const cm730::JointOffsets& offsets) {
  cm730::ProbeOptions options = cm730::ProbeOptions::quick();
  options.port = port;
  options.offsets = offsets;
  cm730::ProbeReport report = cm730::probe(line, options);
  const auto too_old = [](const cm730::ServoFacts& servo) {
    return servo.readable && servo.firmware < cm730::kOldestFirmware;
  };
  const cm730::RobotFacts& facts = report.facts;
  const std::string ask_more = "Ask for the whole list with: darwinop doctor --robot " + port;
  if (facts.lost || (!facts.board.found && !facts.board.garbled))
    throw cm730::NotReady("the robot on " + port + " cannot be driven:\n" + troubles(report.findings) + ask_more);
  if (!facts.board.readable || servosFound(facts) == 0 || std::ranges::any_of(facts.servo, too_old))
    throw std::runtime_error("the robot on " + port + " cannot be driven:\n" + troubles(report.findings) + ask_more);
  // The bus would give up on the servos at the end of the chain in every cycle, and they would count as silent.
  if (const Nanos cycle = cm730::cycleTime(facts); cycle > period - kSpare)
    throw std::runtime_error("the robot on " + port + " cannot be driven with a period of " + inMs(period) +
                             ": a cycle takes " + inMs(cycle) + "\n" + troubles(report.findings) + ask_more);
  return report;
}

}  // namespace

OpenedBus openSerialBus(const std::string& port, Nanos period, const cm730::JointOffsets& offsets) {
  if (period < kShortestPeriod)
    throw std::runtime_error("a period of " + std::to_string(period.count() / 1'000) +
                             " us is too short for the bus, where a cycle takes up to 5.5 ms; choose 8 ms or more");
  auto line = std::make_unique<cm730::SerialPort>(port);
  const cm730::ProbeReport probed = lookAt(*line, port, period, offsets);
  OpenedBus opened;
  opened.description = describe(port, probed.facts);
  opened.warnings = troubles(probed.findings) + troubles(startPoseFindings(probed.facts));
  opened.bus =
      std::make_unique<OwnedBus<cm730::SerialPort>>(std::move(line), cm730::BusConfig::forPeriod(period, offsets));
  return opened;
}

std::unique_ptr<runtime::RobotLink> connect(const Request& request) {
  const Setting setting = readSetting(request.setting);
  switch (setting.kind) {
    case Kind::kDaemon:
      return daemonsRobot(request);
    case Kind::kSerial:
      return serialRobot(request, setting.port);
    case Kind::kVirtual:
      return virtualRobot(request);
    case Kind::kTwin:
      return twin(request, setting.model);
    case Kind::kTcp:
      return robotOverTcp(request, setting.server);
  }
  throw std::logic_error("a kind of robot that connect() does not know");
}

}  // namespace darwinop::link
