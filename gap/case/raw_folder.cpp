// Raw logs and declarations to a case.
#include "gap/case/raw_folder.hpp"

#include <algorithm>

#include "gap/case/bam_log.hpp"
#include "gap/case/contradictions.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/known_servos.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/write_time.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOwnServo = "darwin-op";  // model whose servo is the MX-28

/// Numbers of a known motor. Returns what has to be declared of an unknown one; empty: nothing.
std::string takeSheet(Declarations& declared, FolderCase& in) {
  const double greatest_kp = std::ranges::max(in.given.logs, {}, &Trajectory::p_register).p_register;
  const auto numbers = numbersOf(in.motor, greatest_kp, in.given.model.servo);
  if (numbers) {
    const std::vector<std::string> notes = declareSheet(in.motor, *numbers, declared);
    in.notes.insert(in.notes.end(), notes.begin(), notes.end());
    return declared.missingOfGain();
  }
  const std::string missing = declared.missingOfServo();
  return missing.empty() ? "" : missing + "\n  or --model FILE, a model of motor \"" + in.motor + "\"";
}

FolderCase fromBam(const RawFolder& request, Declarations declared) {
  for (const char* const key : {"kp", "payload_kg", "length_m", "arm_mass_kg", "joint", "torque_on"})
    if (declared.text(key)) throw BadInput("--declare " + std::string{key} + " " + messages::kOfCsv);
  if (!declared.encodings().empty())
    throw BadInput("--declare " + declared.encodings().begin()->first + " " + messages::kOfCsv);
  const std::string model = request.model.empty() ? kOwnServo : request.model;
  FolderCase out = readBamFolder(request.folder, model, declared);
  std::string missing = takeSupply(declared, out);
  if (request.model.empty()) missing += takeSheet(declared, out);
  if (!missing.empty()) throw BadInput(request.folder + messages::kNotDeclared + missing);
  if (declared.describeServo()) {
    out.given.model.servo = declared.servoFrom(out.given.model.servo, out.notes);
    out.given.model.effects.clear();  // friction of another servo
    out.notes.push_back("motor \"" + out.motor +
                        "\" has the numbers above and those declared, and the others of model " + model);
  } else {
    out.notes.push_back("motor \"" + out.motor + "\" has the numbers of model " + model + "; correct them in the case");
  }
  if (!declared.text("goal_order") && !declared.text(kWriteTimeKey)) out.notes.emplace_back(messages::kBamOrder);
  checkBamLogs(declared, out);
  return out;
}

FolderCase fromCsv(const RawFolder& request, const Declarations& declared) {
  if (declared.text("motor")) throw BadInput(std::string{"--declare motor "} + messages::kOfBam);
  twin::Model model;
  try {
    model = twin::readModel(twin::findModel(request.model.empty() ? kOwnServo : request.model));
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  std::erase_if(model.effects, [](const twin::EffectSetting& effect) { return effect.joint.has_value(); });
  std::vector<std::string> notes;
  if (declared.describeServo()) {
    model.servo = declared.servoFrom(model.servo, notes);
    model.effects.clear();  // friction of another servo
  }
  model.servo.supply_v = declared.number("supply_V").value_or(model.servo.supply_v);
  FolderCase out = readCsvFolder(request, declared, model);
  out.notes.insert(out.notes.end(), notes.begin(), notes.end());
  return out;
}

/// Folders of CSVs may have a metadata.json.
bool isBam(const RawFolder& request) {
  if (request.format != RawFormat::kByFiles) return request.format == RawFormat::kBam;
  if (filesEndingWith(request.folder, ".csv").empty()) return true;
  return std::ranges::any_of(filesEndingWith(request.folder, ".json"), [](const fs::path& path) {
    return readTextFile(path.string(), kLongestBamLog).value_or("").find("\"entries\"") != std::string::npos;
  });
}

}  // namespace

std::vector<fs::path> filesEndingWith(const std::string& folder, const char* end) {
  std::error_code failed;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, failed})
    if (entry.path().extension() == end && entry.is_regular_file()) found.push_back(entry.path());
  if (failed) throw BadInput("cannot read " + folder + ": " + failed.message());
  std::ranges::sort(found);
  return found;
}

std::string nameOfFolder(const std::string& folder) {
  return fs::path{folder + "/."}.parent_path().filename().string();
}

bool isRawFolder(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored) || fs::exists(fs::path{folder} / "case.json", ignored)) return false;
  return !filesEndingWith(folder, ".json").empty() || !filesEndingWith(folder, ".csv").empty();
}

FolderCase readRawFolder(const RawFolder& request) {
  const Declarations declared{request.declared};
  FolderCase out = isBam(request) ? fromBam(request, declared) : fromCsv(request, declared);
  noteUnusable(out);
  if (const auto before_s = declared.number(kWriteTimeKey)) setWriteTime(*before_s, out.given);
  holdOut(request.held_out, out);
  request.all_logs ? noteAllLogs(out) : chooseLogs(out);
  for (const Contradiction& found : contradictionsOf(out.given)) out.notes.push_back(asSentence(found));
  return out;
}

}  // namespace darwinop::gap
