// Cases of the whole robot.
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/json/json_text.hpp"
#include "core/text/shell_word.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/export/body/body_export.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/identify/body/compared_models.hpp"
#include "gap/identify/body/mechanics_text.hpp"
#include "gap/localize/body/floor_rows.hpp"
#include "gap/report/body/body_additions.hpp"
#include "gap/report/body/body_report.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/read_results.hpp"
#include "gap_commands.hpp"
#include "gap_files.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

BodyCase readBody(const Arguments& given) {
  BodyCase read = readBodyCase(given.folder);
  if (!given.model.empty()) read.joints.model = twin::readModel(twin::findModel(given.model));
  for (const std::string& warning : read.warnings) std::cerr << "darwinop gap: " << warning << '\n';
  return read;
}

/// The file that the model is from.
std::string modelText(const Arguments& given, const BodyCase& read) {
  if (!given.model.empty()) return textOf(twin::findModel(given.model));
  const fs::path own = fs::path{read.folder} / read.model;
  return textOf(fs::is_regular_file(own) ? own.string() : twin::findModel(read.model));
}

}  // namespace

int checkBody(const Arguments& given) {
  const BodyCase read = readBody(given);
  std::cout << asText(read, checkData(read));
  return 0;
}

int locateBody(const Arguments& given) {
  const BodyCase read = readBody(given);
  const ClampedRobot robot{read};
  const BodyTable table = withFloor(localize(read, RestingImu{read.joints.model}, robot), robot);
  std::cout << (given.json ? jsonText(asJson(table), 1) + "\n" : asText(table));
  return 0;
}

namespace {

/// The search, and what it found as text and files.
int searchRobot(const BodyCase& read, const Arguments& given, const std::string& folder) {
  const BodyIdentification found = identify(read);
  BodyReport report = reportOf(read, found, modelText(given, read));
  const std::string on = text::shellWord(given.folder);
  report.commands = {"darwinop gap run" + modelOption(given) + " " + on};
  if (!report.answer["effects"].empty()) {
    report.commands.push_back("darwinop gap add" + modelOption(given) + " " + on + " " +
                              text::shellWord(folder + "/report.json") + " --out repaired.ini");
    report.commands.push_back("darwinop gap locate --model repaired.ini " + on);
  }
  std::cout << (given.json ? jsonText(report.answer, 1) + "\n" : asText(found));
  for (const std::string& sentence : report.left_out) std::cerr << "darwinop gap: " << sentence << '\n';
  if (!given.out.empty()) {
    writeModelFile(given.out, report.model_after, read.joints.model);
    std::cerr << "darwinop gap: " << given.out << " is the model with the effects; the twin reads it\n";
  }
  if (!given.no_report) {
    writeReport(report, folder);
    putBody(read.joints.model, folder, twin::OtherBody::kReplace);
    showReport(given, folder, !report.answer["effects"].empty());
  }
  return exitCodeOf(found.verdict);
}

}  // namespace

int runBody(const Arguments& given) {
  const BodyCase read = readBody(given);
  const std::string folder = reportFolder(given, read.name);
  if (!given.no_report) requireReportFolder(folder);
  return deliver([&] { return searchRobot(read, given, folder); });
}

int addToBody(const Arguments& given) {
  if (given.results.empty() || !given.effects.empty())
    throw std::runtime_error(
        "add needs report.json of a run for a whole robot, and no --effect, as in darwinop gap add CASE "
        "gap-report/CASE/report.json");
  const BodyCase read = readBody(given);
  const std::string before = modelText(given, read);
  const BodyAdditions added = bodyAdditionsIn(textOf(given.results), given.results, read.name, read.joints.model);
  for (const std::string& warning : {otherModelWarning(textOf(given.results), given.results, read.name, before),
                                     otherDataWarning(textOf(given.results), given.results, dataHash(read))})
    if (!warning.empty()) std::cerr << "darwinop gap: " << warning << '\n';
  const std::string text = withAdditions(before, added.additions);
  if (given.out.empty())
    std::cout << text;
  else
    writeModelFile(given.out, text, read.joints.model);
  for (const AddedEffect& effect : added.additions.effects)
    std::cerr << "darwinop gap: " << effect.id << " at "
              << (effect.joints.empty() ? "all joints" : placesText(effect.joints)) << " added\n";
  for (const AddedNumber& number : added.additions.numbers)
    std::cerr << "darwinop gap: [" << number.section << "] " << number.key << " changed\n";
  for (const AddedAxes& axes : added.additions.axes)
    std::cerr << "darwinop gap: [" << axes.section << "] " << axes.key << " changed\n";
  for (const std::string& sentence : added.left_out) std::cerr << "darwinop gap: " << sentence << '\n';
  return 0;
}

int compareOnBody(const Arguments& given) {
  if (!given.report.empty() || given.open) throw std::runtime_error(messages::kNoPageOfBody);
  const BodyCase read = readBody(given);
  const twin::Model after = twin::readModel(twin::findModel(given.after));
  const twin::Model before = given.before.empty() ? read.joints.model : twin::readModel(twin::findModel(given.before));
  const HeldOutGap gap = compareModels(read, before, after);
  std::cout << (given.json ? jsonText(comparedJson(read, gap), 1) + "\n" : comparedText(read, gap));
  return 0;
}

int writeBodyFor(const Arguments& given) {
  const BodyCase read = readBody(given);
  const ExportSettings settings{.model = read.joints.model.name};
  const Export made = exportBody(targetFrom(given.target).value(), read.joints.model, settings);
  if (given.out.empty())
    std::cout << made.text;
  else
    writeTextFile(given.out, made.text);
  for (const std::string& lost : made.lost) std::cerr << "lost: " << lost << '\n';
  for (const std::string& approximated : made.approximated) std::cerr << "approximated: " << approximated << '\n';
  return 0;
}

}  // namespace darwinop::gap
