// Records a case of the whole robot: checks what is asked for, makes the recordings, and writes the case.json.
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "connect/setting.hpp"
#include "connect/twin_library.hpp"
#include "core/text/number_text.hpp"
#include "exit_codes.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/reader.hpp"
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

/// The model of a case that is there.
std::string modelOf(const BodyCase& so_far, const Arguments& given) {
  const std::string copy = (fs::path{given.out} / so_far.model).string();
  std::error_code no_such_file;
  if (!given.model.empty() && given.model != so_far.model && !fs::equivalent(given.model, copy, no_such_file))
    throw std::runtime_error(given.out + messages::kHasItsModel);
  return so_far.model;
}

/// --resume without --model: as the first command had it, which the folder shows.
bool hasModelOfFirstCommand(const Arguments& given) {
  const std::string model = (fs::path{given.out} / kModelFile).string();
  if (!given.resume || !given.model.empty() || !fs::exists(model)) return false;
  std::cerr << "darwinop gap: " << model << messages::kModelOfFirstCommand << '\n';
  (void)twin::readModel(model);
  return true;
}

/// "0,-1,0" as a unit vector.
Axes upFrom(const std::string& text) {
  std::istringstream words{text};
  std::vector<double> numbers;
  for (std::string word; std::getline(words, word, ',');)
    numbers.push_back(text::numberFromText(word).value_or(std::nan("")));
  const double length = numbers.size() == 3 ? std::hypot(numbers[0], numbers[1], numbers[2]) : 0;
  if (!(length > 0)) throw std::runtime_error("--up " + text + messages::kNotADirection);
  return {numbers[0] / length, numbers[1] / length, numbers[2] / length};
}

/// That of --add, in a file of its own.
PlannedRecording added(const Arguments& given) {
  if (!experiments::readExperiment(experiments::findExperiment(given.add)).setup.is_clamped)
    throw std::runtime_error("--add " + given.add + messages::kNotClamped);
  const std::string stem = fs::path{given.add}.stem().string();
  std::string file = stem + ".csv";
  for (int number = 2; fs::exists(fs::path{given.out} / file); ++number)
    file = stem + "_" + std::to_string(number) + ".csv";
  return addedRecording(file, given.add, upFrom(given.up));
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
  const std::string file = (fs::path{given.out} / "case.json").string();
  const bool is_added = !given.add.empty(), is_there = fs::exists(file);
  if (is_there && !is_added && !given.resume) throw std::runtime_error(file + messages::kRecordingExists);
  if (given.resume && fs::exists(fs::path{given.out} / "standing.csv")) given.floor = true;
  const std::vector<PlannedRecording> plans = is_added ? std::vector{added(given)} : plannedRecordings(given.floor);
  for (const PlannedRecording& plan : plans)
    if (const fs::path recording = fs::path{given.out} / plan.file; !given.resume && fs::exists(recording))
      throw std::runtime_error(recording.string() + messages::kRecordingExists);
  std::optional<BodyCase> so_far;
  if (is_added || is_there) so_far = readBodyCase(given.out);
  makeFolder(given.out);
  // Ctrl-C ends the experiment, gently, and then this program.
  onEndSignals([](int number, siginfo_t*, void*) { ended_by = number; });
  const std::string model = so_far                          ? modelOf(*so_far, given)
                            : hasModelOfFirstCommand(given) ? kModelFile
                                                            : modelFor(given.model, given.out);
  const std::string own_model = (fs::path{given.out} / model).string();
  const auto kind = robot.kind == RobotKind::kTwin ? RecordedRobot::kSimulated : RecordedRobot::kPhysical;
  const std::string twin = robot.kind == RobotKind::kTwin ? connect::twinInHead(robot.model) : "";
  BodyRecorder recorder{given, twin, fs::exists(own_model) ? own_model : model, ended_by};
  if (is_added)
    recorder.goOn(*so_far);
  else
    recorder.keep(plans);
  try {
    if (!recorder.record(plans)) {
      std::cerr << (is_added ? "darwinop gap: stopped; nothing was added\n"
                             : "darwinop gap: stopped; to go on, give the same command with --resume\n");
      return app::kStopped;
    }
  } catch (const RecordingFailed& failed) {
    std::cerr << "darwinop gap: " << failed.what() << '\n';
    return app::kFailed;
  }
  const std::vector<MadeRecording> made = recorder.made(plans);
  const std::string name = nameOfFolder(given.out);
  writeTextFile(file, so_far ? withEntries(textOf(file), file, made)
                             : bodyCaseJson(name.empty() ? "robot" : name, model, kind, made));
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << '\n';
  return 0;
}

}  // namespace darwinop::gap
