// darwinop-calibrate: measures what is individual in a robot and keeps it in robot.ini.
#include <time.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "apps/calibrate/by_hand.hpp"
#include "apps/calibrate/imu_procedure.hpp"
#include "apps/calibrate/imu_text.hpp"
#include "apps/calibrate/ini_edit.hpp"
#include "apps/calibrate/messages.hpp"
#include "apps/calibrate/opened_robot.hpp"
#include "calibrate_commands.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "exit_codes.hpp"
#include "hal/signals.hpp"
#include "hal/text_file.hpp"
#include "parse_arguments.hpp"

namespace {

using namespace darwinop;
namespace messages = calibrate::messages;

using calibrate::CalibrateOptions;
using calibrate::kExitDone;
using calibrate::kExitNothing;
using calibrate::kExitWrong;

/// A measurement of minutes is not lost by another answer than y or n; the end of the input is n.
bool confirmed(const CalibrateOptions& given, const std::string& file) {
  if (given.yes) return true;
  std::cout << "\nWrite this to " << file << (readTextFile(file) ? "? The old file is kept." : ", a new file?");
  for (std::string answer;;) {
    std::cout << " y or n, and Enter > " << std::flush;
    if (!std::getline(std::cin, answer)) return false;
    answer = text::lowered(text::withoutBlanks(answer));
    if (answer == "y" || answer == "yes") return true;
    if (answer == "n" || answer == "no") return false;
  }
}

}  // namespace

namespace darwinop::calibrate {

std::string timeText(const char* format) {
  char text[32];
  const time_t now = time(nullptr);
  tm local{};
  localtime_r(&now, &local);
  strftime(text, sizeof text, format, &local);
  return text;
}

OpenedRobot openToWrite(const CalibrateOptions& given, bool unattended) {
  OpenedRobot robot = openRobot(given.robot, given.file, unattended);
  const std::string file = fileToWrite(robot, given.file);
  if (!file.empty() && !given.dry_run) requireReplaceable(file);
  return robot;
}

int keep(const CalibrateOptions& given, const std::string& file, const std::string& section,
         const std::vector<IniValue>& values) {
  if (values.empty()) {
    std::cout << messages::kNothingWritten << '\n';
    return kExitNothing;
  }
  if (given.dry_run || file.empty()) {
    std::cout << messages::kNothingWritten << (file.empty() ? "; a twin's values go to a file that --file names" : "")
              << '\n';
    return given.dry_run ? kExitDone : kExitNothing;
  }
  if (!confirmed(given, file)) {
    std::cout << messages::kNothingWritten << '\n';
    return kExitNothing;
  }
  const std::string text = withValues(readTextFile(file).value_or(""), section, values);
  // An offset may leave nothing of a range in [Limits], with which no program would start.
  static_cast<void>(connect::safetyOn(connect::parseRobotFile(text, file), {}, file));
  const std::string kept = replaceKeepingOld(file, text, timeText("%Y%m%d-%H%M%S"));
  std::cout << "written: " << file << (kept.empty() ? "" : "\nold file: " + kept) << '\n';
  return kExitDone;
}

#ifndef DARWINOP_CALIBRATES_JOINTS
int calibrateJoints(const CalibrateOptions&) {
  throw std::runtime_error(
      "zero offsets are measured on a PC, with the CM-730's USB cable in it: the masses of the links are there");
}
#endif

}  // namespace darwinop::calibrate

namespace {

int calibrateImu(const CalibrateOptions& given) {
  calibrate::OpenedRobot robot = calibrate::openToWrite(given, given.yes);
  if (!robot.is_twin)
    std::cout
        << "Nothing moves. You hold the trunk still in six postures, " << given.seconds
        << " s each; a spirit level on its flat sides makes the result as exact as the level. Joints may be limp or "
           "not. It takes a few minutes.\n";
  const auto time = std::chrono::duration_cast<Nanos>(std::chrono::duration<double>{given.seconds});
  const std::vector<calibrate::PostureReading> readings =
      calibrate::readPostures(*robot.link, *robot.stand, robot.file.imu, time, endRequested(), std::cout);
  if (endRequested()) return kExitNothing;
  const calibrate::ImuFit fit = calibrate::fitImu(readings, given.level_deg, robot.file.imu);
  if (!fit.observed) {
    std::cerr << "darwinop calibrate: " << messages::kTooFewPostures << '\n';
    return kExitNothing;
  }
  std::cout << calibrate::asText(fit, robot.file.imu);
  return calibrate::keep(given, calibrate::fileToWrite(robot, given.file), "Imu",
                         calibrate::iniValues(fit, calibrate::timeText("%Y-%m-%d")));
}

int calibrateByHand(const CalibrateOptions& given) {
  if (given.yes) throw std::runtime_error(messages::kYesByHand);
  std::vector<Joint> joints;
  for (const std::string& name : given.joints) {
    const auto joint = findJoint(jointName(name));
    if (!joint) throw std::runtime_error(name + messages::kNoSuchJoint);
    joints.push_back(*joint);
  }
  calibrate::OpenedRobot robot = calibrate::openToWrite(given, false);
  const std::vector<calibrate::HeldJoint> held =
      calibrate::readHeldJoints(*robot.link, joints, std::cin, endRequested(), std::cout);
  if (endRequested()) return kExitNothing;
  if (held.empty()) {
    std::cerr << "\ndarwinop calibrate: " << messages::kNoJointRead << '\n';
    return kExitNothing;
  }
  std::cout << calibrate::asText(held, robot.file.offsets);
  return calibrate::keep(given, calibrate::fileToWrite(robot, given.file), "Offsets",
                         calibrate::iniValues(held, robot.file.offsets, calibrate::timeText("%Y-%m-%d")));
}

void describe(CLI::App& app, CalibrateOptions& a) {
  app.add_option("--robot", a.robot,
                 "serial port of the robot, or twin[:MODEL]; default: DARWINOP_ROBOT, else the port of robot.ini");
  app.add_option("--file", a.file, "robot.ini to read and write; default: the one that programs read");
  app.add_flag("--yes", a.yes, "ask nothing; twins only, because a person has to hold a robot");
  app.add_flag("--dry-run", a.dry_run, "measure and show, write nothing");
}

int command(int count, char** arguments) {
  CLI::App app{"Measures what is individual in a robot and keeps it in robot.ini. docs/calibrate.md",
               "darwinop calibrate"};
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  darwinop calibrate imu                                      on the robot, the runtime stopped\n"
      "  darwinop calibrate imu --robot twin --yes --file robot.ini  try it without hardware\n"
      "  darwinop calibrate joints --robot /dev/ttyUSB0 --file robot.ini  on a PC, trunk in a stand\n"
      "  darwinop calibrate by-hand Neck FootR                       limp joints, held at zero\n"
      "Exit status: 0 done, 1 nothing found or written, 2 invalid arguments, file or robot, 130 Ctrl-C.");
  CalibrateOptions a;
  CLI::App& imu = *app.add_subcommand("imu", "gyroscope and accelerometer: bias, scale, mounting; nothing moves");
  describe(imu, a);
  imu.add_option("--seconds", a.seconds, "in each posture")->check(CLI::Range(1.0, 60.0))->capture_default_str();
  imu.add_option("--level-deg", a.level_deg, "how exactly you level the trunk, standard deviation in deg")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  CLI::App& joints = *app.add_subcommand("joints", "zero offsets by gravity, trunk clamped; arms, legs, head swing");
  describe(joints, a);
  joints.add_option("--model", a.model, "twin model with the masses of the links")->capture_default_str();
  CLI::App& by_hand = *app.add_subcommand("by-hand", "zero offsets of limp joints that you hold at zero");
  describe(by_hand, a);
  by_hand.get_option("--yes")->group("");  // refused
  by_hand.add_option("JOINT", a.joints, "names of joints, e.g. Neck FootR")->required();
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  // Not as the option's default: the library would set it for each subcommand, and the last one wins.
  if (const char* usual = std::getenv("DARWINOP_ROBOT"); a.robot.empty() && usual != nullptr) a.robot = usual;
  endOnSignals();
  const int status = by_hand.parsed()  ? calibrateByHand(a)
                     : joints.parsed() ? calibrate::calibrateJoints(a)
                                       : calibrateImu(a);
  if (status == kExitDone || !endRequested()) return status;
  std::cerr << "\ndarwinop calibrate: " << messages::kStopped << '\n';
  return app::kStopped;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return command(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << "darwinop calibrate: " << error.what() << '\n';
    return kExitWrong;
  }
}
