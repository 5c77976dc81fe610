// Records a case of the whole robot: checks what is asked for, makes the recordings, and writes the case.json.
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "connect/setting.hpp"
#include "connect/twin_library.hpp"
#include "exit_codes.hpp"
#include "gap/case/folder_files.hpp"
#include "gap_commands.hpp"
#include "gap_files.hpp"
#include "gap_recorder.hpp"
#include "hal/cm730/port_messages.hpp"
#include "hal/signals.hpp"
#include "hal/write_text_file.hpp"
#include "twin/model/copy_body.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;
using connect::RobotKind;

constexpr const char* kModelFile = "model.ini";  // of the case

/// The last signal that asks us to end; 0: none.
std::atomic<int> ended_by{0};
static_assert(std::atomic<int>::is_always_lock_free);

/// Name of the model for the case; a file is copied into its folder. Throws std::runtime_error if another one is there.
std::string modelFor(const std::string& wanted, const std::string& folder) {
  std::string name = wanted.empty() ? "darwin-op" : wanted;
  const std::string path = twin::findModel(name), copy = (fs::path{folder} / kModelFile).string();
  if (path != name) return name;  // a shipped one
  const twin::Model model = twin::readModel(path);
  const bool is_there = fs::exists(copy);
  if (is_there && textOf(copy) != textOf(path)) throw std::runtime_error(copy + messages::kOtherModel);
  if (const std::string wrong = twin::copyBody(model, folder, twin::OtherBody::kKeep); !wrong.empty())
    throw std::runtime_error(wrong);
  if (!is_there) fs::copy_file(path, copy);
  return kModelFile;
}

/// --resume without --model or --floor: as the first command had them, which the folder shows.
bool takeFirstCommand(Arguments& given) {
  if (!given.resume) return false;
  if (fs::exists(fs::path{given.out} / "standing.csv")) given.floor = true;
  const fs::path model = fs::path{given.out} / kModelFile;
  if (!given.model.empty() || !fs::exists(model)) return false;
  std::cerr << "darwinop gap: " << model.string() << messages::kModelOfFirstCommand << '\n';
  (void)twin::readModel(model.string());
  return true;
}

connect::Setting settingOf(const std::string& robot) {
  connect::Setting setting = connect::readSetting(robot);
  if (connect::loopIsElsewhere(setting))
    throw std::runtime_error("the loop of this robot runs elsewhere and records itself; give its serial port");
  if (setting.kind == RobotKind::kVirtual)
    throw std::runtime_error("the virtual robot has no weight; use twin, or twin:MODEL");
  if (setting.kind == RobotKind::kSerial) cm730::requirePort(setting.port);  // before anyone clamps it
  return setting;
}

}  // namespace

int recordBody(const Arguments& asked) {
  Arguments given = asked;
  if (const char* const usual = std::getenv("DARWINOP_ROBOT"); given.robot.empty() && usual != nullptr)
    given.robot = usual;
  const connect::Setting robot = settingOf(given.robot);
  const std::string file = newCaseFile(given.out);
  const bool has_model = takeFirstCommand(given);
  const std::vector<PlannedRecording> plans = plannedRecordings(given.floor);
  for (const PlannedRecording& plan : plans)
    if (const fs::path recording = fs::path{given.out} / plan.file; !given.resume && fs::exists(recording))
      throw std::runtime_error(recording.string() + messages::kRecordingExists);
  makeFolder(given.out);
  // Ctrl-C ends the experiment, gently, and then this program.
  onEndSignals([](int number, siginfo_t*, void*) { ended_by = number; });
  const std::string model = has_model ? kModelFile : modelFor(given.model, given.out);
  const bool is_file = model == kModelFile;
  const auto kind = robot.kind == RobotKind::kTwin ? RecordedRobot::kSimulated : RecordedRobot::kPhysical;
  const std::string twin = robot.kind == RobotKind::kTwin ? connect::twinInHead(robot.model) : "";
  BodyRecorder recorder{given, twin, is_file ? (fs::path{given.out} / model).string() : model, ended_by};
  recorder.keep(plans);
  try {
    if (!recorder.record(plans)) {
      std::cerr << "darwinop gap: stopped; to go on, give the same command with --resume\n";
      return app::kStopped;
    }
  } catch (const RecordingFailed& failed) {
    std::cerr << "darwinop gap: " << failed.what() << '\n';
    return app::kFailed;
  }
  const std::string name = nameOfFolder(given.out);
  writeTextFile(file, bodyCaseJson(name.empty() ? "robot" : name, model, kind, recorder.made(plans)));
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << '\n';
  return 0;
}

}  // namespace darwinop::gap
