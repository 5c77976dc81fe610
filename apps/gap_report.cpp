// Searches, reports, and puts effects into models.
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/json/json_text.hpp"
#include "core/text/shell_word.hpp"
#include "gap/case/body/body_case.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/raw_folder.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/read_results.hpp"
#include "gap/report/report.hpp"
#include "gap_commands.hpp"
#include "gap_files.hpp"
#include "gap_progress.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

void writeAndShow(const Report& report, const Arguments& given, const std::string& folder) {
  writeReport(report, folder);
  if (report.outcome != nullptr) putBody(report.given->model, folder, twin::OtherBody::kReplace);
  showReport(given, folder, report.outcome != nullptr && !report.outcome->identification.effects.empty());
}

/// The model that a case starts from, as a file has it.
std::string startModel(const Arguments& given, const Case& read) {
  return given.model.empty() ? caseModel(read) : textOf(twin::findModel(given.model));
}

}  // namespace

int deliver(const std::function<int()>& work) try { return work(); } catch (const BadInput&) {
  throw;
} catch (const std::exception& error) {
  throw NotDelivered{error.what()};
}

Case readGiven(const Arguments& given) {
  Case read = readCase(given.folder);
  return given.model.empty() ? read : withModel(std::move(read), twin::readModel(twin::findModel(given.model)));
}

void printWarnings(const Case& read) {
  if (!Ranks::isFirst()) return;
  for (const std::string& warning : read.warnings) std::cerr << "darwinop gap: " << warning << '\n';
}

namespace {

int runFolder(const Arguments& given);

/// Raw logs are made into a case beside the report.
int runRaw(Arguments given) {
  if (Ranks::count() > 1) throw std::runtime_error("mpirun needs a case; make one with darwinop gap case");
  given.report = reportFolder(given, nameOfFolder(given.folder));
  const std::string made = (fs::path{given.report} / "case").string();
  makeRawCase(given, given.folder, made);
  std::cerr << "darwinop gap: " << made << " is the case; its case.json has every number that was declared\n";
  given.folder = made;
  given.model.clear();  // the case has it
  given.declared.clear();
  given.held_out.clear();
  given.all_logs = false;
  return runFolder(given);
}

/// A case.json has what these options declare of raw logs.
void refuseRawOptions(const Arguments& given) {
  const auto refuse = [&](const char* option, const char* instead) {
    throw std::runtime_error(given.folder + " has a case.json; " + option + " is for raw logs: " + instead);
  };
  if (!given.declared.empty()) refuse("--declare", "edit case.json instead");
  if (!given.held_out.empty()) refuse("--keep", R"(edit "role" in case.json instead)");
  if (given.all_logs) refuse("--all-logs", R"("role" in case.json says what each log is for)");
}

/// The search, and what it found as text and files.
int searchServo(const Case& read, const Arguments& given, const std::string& folder) {
  ProgressLine progress{given.json || !Ranks::isFirst()};
  IdentifyOptions options;
  options.progress = [&](const std::string& what) { progress.show(what); };
  const Outcome outcome = investigate(read, options);
  Report report = reportOf(read, outcome, startModel(given, read));
  progress.end();
  const std::string on = text::shellWord(given.folder);
  report.commands = {"darwinop gap run" + modelOption(given) + " " + on,
                     "darwinop gap add" + modelOption(given) + " " + on + " " +
                         text::shellWord(folder + "/report.json") + " --out repaired.ini",
                     "darwinop gap report --after repaired.ini" +
                         (given.model.empty() ? "" : " --before " + text::shellWord(given.model)) + " " + on};
  const int code = exitCodeOf(outcome.identification.verdict);
  if (!Ranks::isFirst()) return code;
  std::cout << (given.json ? jsonText(asJson(read, outcome), 1) + "\n" : asText(report)) << std::flush;
  if (!given.out.empty()) {
    writeModelFile(given.out, report.model_after, read.model);
    std::cerr << "darwinop gap: " << given.out
              << " is the case's model with the effects; a robot's model takes its [effect ...] sections\n";
  }
  if (!given.no_report) writeAndShow(report, given, folder);
  return code;
}

int runFolder(const Arguments& given) {
  if (!given.out.empty() && Ranks::isFirst()) requireWritable(given.out);
  if (fs::exists(fs::path{given.folder} / "case.json"))
    refuseRawOptions(given);
  else if (fs::is_directory(given.folder) && !isRawFolder(given.folder))
    throw std::runtime_error(given.folder + messages::kNeitherCaseNorLogs);
  if (isRawFolder(given.folder)) return runRaw(given);
  if (isBodyCase(given.folder)) return Ranks::isFirst() ? runBody(given) : 0;
  const Case read = readGiven(given);
  printWarnings(read);
  const std::string folder = reportFolder(given, read.name);
  if (!given.no_report && Ranks::isFirst()) requireReportFolder(folder);
  return deliver([&] { return searchServo(read, given, folder); });
}

}  // namespace

int run(const Arguments& given) try { return runFolder(given); } catch (const BadInput& bad) {
  if (given.json) std::cout << jsonText(badInput(nameOfFolder(given.folder), bad.what()), 1) << '\n' << std::flush;
  throw;
}

int compareModels(const Arguments& given) {
  if (isBodyCase(given.folder)) return compareOnBody(given);
  const Case read = readCase(given.folder);
  const std::string before = given.before.empty() ? caseModel(read) : textOf(twin::findModel(given.before));
  Report report = reportOn(read, before, textOf(twin::findModel(given.after)));
  report.commands = {"darwinop gap report" +
                     (given.before.empty() ? "" : " --before " + text::shellWord(given.before)) + " --after " +
                     text::shellWord(given.after) + " " + text::shellWord(given.folder)};
  std::cout << (given.json ? jsonText(asJson(report), 1) + "\n" : asText(report)) << std::flush;
  if (!given.no_report) writeAndShow(report, given, reportFolder(given, read.name + "-compared"));
  return 0;
}

int addEffects(const Arguments& given) {
  if (isBodyCase(given.folder)) return addToBody(given);
  const Case read = readGiven(given);
  if (given.results.empty() == given.effects.empty())
    throw std::runtime_error("add needs either report.json of a run or --effect ID.PARAMETER=VALUE");
  const Additions additions = given.results.empty() ? atJoint(additionsFrom(given.effects), read)
                                                    : additionsIn(textOf(given.results), given.results, read);
  const std::string warning =
      given.results.empty() ? "" : otherDataWarning(textOf(given.results), given.results, dataHash(read));
  if (!warning.empty()) std::cerr << "darwinop gap: " << warning << '\n';
  const std::string before = startModel(given, read), text = withAdditions(before, additions);
  if (given.out.empty())
    std::cout << text;
  else
    writeModelFile(given.out, text, read.model);
  for (const std::string& change : changesBy(additions, twin::parseModel(before, "the model")))
    std::cerr << "darwinop gap: " << change << '\n';
  return 0;
}

}  // namespace darwinop::gap
