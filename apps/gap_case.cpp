// Recordings of the robot as a case.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "core/text/shell_word.hpp"
#include "gap/case/bam_log.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/robot/joint_case.hpp"
#include "gap/case/write_case.hpp"
#include "gap/report/data_hash.hpp"
#include "gap_commands.hpp"
#include "gap_files.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

Joint jointCalled(const std::string& name) {
  const auto row = std::ranges::find(kJointTable, name, &JointRow::name);
  if (row == kJointTable.end())
    throw std::runtime_error("there is no joint '" + name + "'; docs/logs.md has their names, such as ShoulderR");
  return static_cast<Joint>(row - kJointTable.begin());
}

int fromRaw(const Arguments& given, const std::string& folder) {
  makeRawCase(given, folder, given.out);
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << "\n";
  return 0;
}

int toBam(const Arguments& given) {
  const Case read = readCase(given.to_bam);
  makeFolder(given.out);
  for (const Trajectory& log : read.logs)
    writeTextFile(fs::path{given.out} / fs::path{log.file}.stem().concat(".json"),
                  asBamJson(read, log, read.model.name));
  return 0;
}

/// A case that the same logs made before may have been edited since.
void refuseToOverwrite(const Case& made, const fs::path& folder) {
  const bool has_model = !fitsBaseline(made);
  std::vector<std::pair<fs::path, std::string>> files{{folder / "case.json", caseAsJson(made, has_model)}};
  if (has_model) files.emplace_back(folder / "model.ini", twin::writeModel(made.model));
  for (const auto& [file, text] : files)
    if (fs::exists(file) && textOf(file.string()) != text)
      throw std::runtime_error(file.string() + messages::kOtherCase + text::shellWord(folder.string()) +
                               ", or give another folder with --report");
}

}  // namespace

void makeRawCase(const Arguments& given, const std::string& raw, const std::string& into) {
  const FolderCase read = readRawFolder({.folder = raw,
                                         .model = given.model,
                                         .declared = given.declared,
                                         .held_out = given.held_out,
                                         .all_logs = given.all_logs,
                                         .format = !given.from_bam.empty()   ? RawFormat::kBam
                                                   : !given.from_csv.empty() ? RawFormat::kCsv
                                                                             : RawFormat::kByFiles});
  refuseToOverwrite(read.given, into);
  writeCase(read.given, into);
  for (const std::string& note : grouped(read.notes)) std::cerr << "darwinop gap: " << note << '\n';
}

int makeCase(const Arguments& given) {
  if (!given.to_bam.empty()) return toBam(given);
  (void)newCaseFile(given.out);
  if (!given.from_bam.empty()) return fromRaw(given, given.from_bam);
  if (!given.from_csv.empty()) return fromRaw(given, given.from_csv);
  if (given.recordings.empty()) throw std::runtime_error("give recordings, or --from-bam FOLDER, or --from-csv FOLDER");
  JointCaseRequest request;
  if (!given.model.empty()) request.model = given.model;
  request.joint = jointCalled(given.jointOrUsual());
  request.recordings = given.recordings;
  request.held_out = given.held_out;
  const JointCaseNotes notes = writeJointCase(request, given.out);
  for (const std::string& warning : notes.warnings) std::cerr << "darwinop gap: " << warning << '\n';
  for (const std::string& sentence : notes.logs) std::cout << sentence << '\n';
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << "\n";
  return 0;
}

}  // namespace darwinop::gap
