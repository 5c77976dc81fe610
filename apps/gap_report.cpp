// Searches, reports, and puts effects into models.
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/json/json_text.hpp"
#include "gap/case/body/body_case.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/report.hpp"
#include "gap_commands.hpp"
#include "gap_progress.hpp"
#include "hal/process/child_process.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestText = 64 << 20;  // bytes: of a report, as darwinop window takes it

std::string textOf(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path, kLongestText);
  if (!text) throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno));
  return *text;
}

void writeTo(const std::string& path, const std::string& text) {
  std::ofstream file{path, std::ios::binary};
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

/// A name of a case that is also one of a folder.
std::string folderName(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || (c == '.' && !out.empty());
    out += plain ? c : '_';
  }
  return out.empty() ? "case" : out;
}

std::string reportFolder(const Arguments& given, const std::string& otherwise) {
  return given.report.empty() ? (fs::path{"gap-report"} / folderName(otherwise)).string() : given.report;
}

/// Where a person sits in front of a screen; not at the far end of an ssh.
bool someoneIsThere() {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return isatty(STDOUT_FILENO) == 1 && (set("DISPLAY") || set("WAYLAND_DISPLAY")) && !set("SSH_CONNECTION");
}

/// The desktop's own program for pages; nothing happens where there is none.
void openInBrowser(const std::string& path) try {
  using process::Stream;
  process::ChildProcess{{.command = {"xdg-open", path}, .streams = {{}, Stream::nothing(), Stream::nothing()}}}
      .detach();
} catch (const std::runtime_error&) {
  std::cerr << "darwinop gap: xdg-open not found; open the page yourself\n";
}

void deliver(const Report& report, const Arguments& given, const std::string& folder) {
  writeReport(report, folder);
  const std::string page = (fs::path{folder} / "report.html").string();
  std::cerr << "darwinop gap: " << page << " is the report; report.json beside it is for programs"
            << (report.outcome == nullptr ? "" : ", repaired.ini the model with the effects") << '\n';
  if (given.open || (!given.no_open && !given.json && someoneIsThere())) openInBrowser(page);
}

std::string modelOption(const Arguments& given) {
  return given.model.empty() ? "" : " --model " + shellWord(given.model);
}

bool hasEffect(const std::string& model, const std::string& id) {
  for (const twin::EffectSetting& effect : twin::parseModel(model, "the model").effects)
    if (effect.info->id == id && !effect.joint) return true;
  return false;
}

/// The model that a case starts from, as a file has it.
std::string startModel(const Arguments& given, const Case& read) {
  return given.model.empty() ? caseModel(read) : textOf(twin::findModel(given.model));
}

}  // namespace

Case readGiven(const Arguments& given) {
  Case read = readCase(given.folder);
  return given.model.empty() ? read : withModel(std::move(read), twin::readModel(twin::findModel(given.model)));
}

void printWarnings(const Case& read) {
  if (!Ranks::isFirst()) return;
  for (const std::string& warning : read.warnings) std::cerr << "darwinop gap: " << warning << '\n';
}

int run(const Arguments& given) {
  if (isBodyCase(given.folder)) return Ranks::isFirst() ? runBody(given) : 0;
  const Case read = readGiven(given);
  printWarnings(read);
  ProgressLine progress{given.json || !Ranks::isFirst()};
  IdentifyOptions options;
  options.progress = [&](const std::string& what) { progress.show(what); };
  const Outcome outcome = investigate(read, options);
  Report report = reportOf(read, outcome, startModel(given, read));
  progress.end();
  const std::string folder = reportFolder(given, read.name), on = shellWord(given.folder);
  report.commands = {"darwinop gap run" + modelOption(given) + " " + on,
                     "darwinop gap add" + modelOption(given) + " " + on + " " + shellWord(folder + "/report.json") +
                         " --out repaired.ini",
                     "darwinop gap report --after repaired.ini" +
                         (given.model.empty() ? "" : " --before " + shellWord(given.model)) + " " + on};
  const int code = exitCodeOf(outcome.identification.verdict);
  if (!Ranks::isFirst()) return code;
  std::cout << (given.json ? jsonText(asJson(read, outcome), 1) + "\n" : asText(report)) << std::flush;
  if (!given.out.empty()) {
    writeTo(given.out, report.model_after);
    std::cerr << "darwinop gap: " << given.out << " is the model with the effects; the twin reads it\n";
  }
  if (!given.no_report) deliver(report, given, folder);
  return code;
}

int compareModels(const Arguments& given) {
  const Case read = readCase(given.folder);
  const std::string before = given.before.empty() ? caseModel(read) : textOf(twin::findModel(given.before));
  Report report = reportOn(read, before, textOf(twin::findModel(given.after)));
  report.commands = {"darwinop gap report" + (given.before.empty() ? "" : " --before " + shellWord(given.before)) +
                     " --after " + shellWord(given.after) + " " + shellWord(given.folder)};
  std::cout << (given.json ? jsonText(asJson(report), 1) + "\n" : asText(report)) << std::flush;
  if (!given.no_report) deliver(report, given, reportFolder(given, read.name + "-compared"));
  return 0;
}

int addEffects(const Arguments& given) {
  const Case read = readGiven(given);
  if (given.results.empty() == given.effects.empty())
    throw std::runtime_error("add needs either report.json of a run or --effect ID.PARAMETER=VALUE");
  const Additions additions =
      given.results.empty() ? additionsFrom(given.effects) : additionsIn(textOf(given.results), given.results, read);
  const std::string before = startModel(given, read), text = withAdditions(before, additions);
  if (given.out.empty())
    std::cout << text;
  else
    writeTo(given.out, text);
  for (const AddedEffect& effect : additions.effects)
    std::cerr << "darwinop gap: " << effect.id << (hasEffect(before, effect.id) ? " replaced\n" : " added\n");
  return 0;
}

}  // namespace darwinop::gap
