// darwinop-doctor: checks computer, port, board and servos, with a fix for each finding.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "connect/robot_file.hpp"
#include "connect/robot_file_finding.hpp"
#include "connect/serial_bus.hpp"
#include "connect/start_pose_findings.hpp"
#include "doctor_report.hpp"
#include "hal/cm730/diagnosis/host_checks.hpp"
#include "hal/cm730/diagnosis/port_check.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/serial_open.hpp"
#include "parse_arguments.hpp"

namespace {

using namespace darwinop;
using cm730::Finding;

constexpr int kLoopPriority = 80;  // same as the loop's thread

constexpr const char* kExample =
    "Examples:\n"
    "  darwinop doctor                        DARWINOP_ROBOT, else robot.ini's port, else the first USB one\n"
    "  darwinop doctor --robot /dev/ttyUSB1\n"
    "  darwinop doctor --fix                  also corrects return delays and status levels\n"
    "  darwinop doctor --json                 one JSON document; keys: docs/doctor.md\n"
    "Nothing moves; torque is not changed. Servo power is switched on if it is off.\n"
    "Exit code: 0 the robot can be driven (warnings allowed), 1 it cannot, 2 wrong arguments.";

struct WrongPort : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Nothing, and an error finding, if robot.ini is invalid.
std::optional<connect::RobotFile> readRobotFile(app::DoctorReport& report) {
  try {
    return connect::readRobotFile();
  } catch (const std::exception& wrong) {
    report.add({Finding::of(cm730::Kind::kRobotFile, wrong.what(),
                            "correct the file (docs/robot-file.md); the file is ignored here")});
    return std::nullopt;
  }
}

/// Throws WrongPort.
std::string portOf(const std::string& asked, const std::optional<connect::RobotFile>& file) try {
  const std::string from_file = file ? file->port.value_or("") : "";
  return cm730::choosePort(asked.empty() ? from_file : asked, cm730::candidatePorts());
} catch (const std::exception& error) {
  throw WrongPort{error.what()};
}

int examine(const std::string& asked, bool fix, bool json) {
  app::DoctorReport report{json};
  report.begin("computer");
  report.add(cm730::diagnoseHost(cm730::measureHost(kLoopPriority)));

  const std::optional<connect::RobotFile> file = readRobotFile(report);
  const connect::RobotFile robot = file.value_or(connect::RobotFile{});
  const std::string path = portOf(asked, file);
  if (file) report.add({connect::robotFileFinding(robot, path)});

  report.begin("port");
  const cm730::PortCheck check = cm730::checkPort(path);
  report.add(check.findings);
  cm730::ProbeReport probed;
  probed.facts.port = path;
  const auto finish = [&] { return report.finish(path, cm730::nameFaults(probed.facts, report.findings())); };
  if (!check.port) return finish();

  report.begin(app::DoctorReport::kRobotPart);
  cm730::ProbeOptions options = cm730::ProbeOptions::thorough();
  options.port = path;
  options.offsets = robot.offsets;
  options.period = robot.period.value_or(connect::kUsualPeriod);
  options.absent = robot.safety.absent;
  const safety::Config safety = connect::safetyOn(robot, {}, "config.ini");
  options.allowed = connect::goalTicks(safety, robot.offsets);
  options.correct = options.correct_mute = fix;
  options.permitted = robot.permitted;
  probed = cm730::probe(*check.port, options);
  report.add(probed.findings);
  report.add(cm730::underTorqueRows(probed.facts));
  if (probed.facts.board.isKnown() && probed.facts.board.suppliesServos()) {
    report.begin("pose");
    report.add(connect::startPoseFindings(probed.facts, safety));
  }
  return finish();
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Checks computer, port, board and servos; one line each, with a fix.", "darwinop doctor"};
  app.footer(kExample);
  std::string robot;
  bool fix = false, json = false;
  app.add_option("--robot", robot, "serial port or pty of the robot")->envname("DARWINOP_ROBOT");
  app.add_flag("--fix", fix, "write wrong servo settings (EEPROM) while torque is off");
  app.add_flag("--json", json, "one JSON document instead of lines");
  app.set_version_flag("--version", DARWINOP_VERSION);
  if (const auto code = darwinop::app::parseArguments(app, argc, argv)) return *code;
  return examine(robot, fix, json);
} catch (const WrongPort& error) {
  std::fprintf(stderr, "darwinop doctor: %s\n", error.what());
  return app::kWrong;
} catch (const std::exception& error) {
  std::fprintf(stderr, "darwinop doctor: %s\n", error.what());
  return 1;
}
