// A folder of CSVs as a case: its case.json is made of columns and declarations, and then read like any other.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "experiments/logs/header.hpp"
#include "gap/case/declared_case.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/joint_columns.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "gap/case/raw_folder.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

/// The one value of a column, whose empty cells are not received; nothing: the log has no such value.
std::optional<double> constantIn(const logs::Log& log, std::string_view name) {
  const logs::Column* const column = log.find(name);
  if (column == nullptr) return std::nullopt;
  std::optional<double> one;
  for (const double value : column->values) {
    if (std::isnan(value)) continue;
    if (one && value != *one)
      throw BadInput(log.file + ": column " + logs::quotedField(name) + " " + messages::kSeveralValues);
    one = value;
  }
  return one;
}

/// Entry of a log: its own columns, else what is declared. Appends to `missing`.
Json entryOf(const logs::Log& log, const std::string& file, const Declarations& declared, std::string& missing) {
  Json entry = {{"file", file}, {"trajectory", fs::path{file}.stem().string()}};
  for (const BenchKey& key : benchKeys()) {
    std::optional<double> value = constantIn(log, key.key);
    if (!value) value = declared.number(key.key);
    if (!value) value = key.otherwise;
    if (value)
      entry[std::string{key.key}] = *value;
    else
      missing += Declarations::missing(key.key, std::string{key.meaning} + "; or a column of that name in " + file);
  }
  return entry;
}

/// The files of the folder, as logs of one servo. `notes` outlives the result.
CaseFiles filesOfServo(const RawFolder& request, const Declarations& declared, std::vector<std::string>& notes) {
  CaseFiles files = filesIn(request.folder);
  files.log = [=, as_written = files.log, joint = declared.text("joint"), torque = declared.number("torque_on"),
               &notes](const std::string& name) {
    logs::Log log = as_written(name);
    if (joint) log = columnsOfJoint(std::move(log), *joint, notes);
    return torque ? withTorque(std::move(log), *torque) : log;
  };
  return files;
}

}  // namespace

FolderCase readCsvFolder(const RawFolder& request, const Declarations& declared, const twin::Model& model) {
  FolderCase out;
  out.given.folder = request.folder;
  const CaseFiles files = filesOfServo(request, declared, out.notes);
  Json logs = Json::array();
  std::string missing;  // of the first log that lacks something
  const std::vector<fs::path> paths = filesEndingWith(request.folder, ".csv");
  if (paths.empty()) throw BadInput(request.folder + ": " + messages::kNoCsvs);
  for (const fs::path& path : paths) {
    std::string of_log;
    const std::string file = path.filename().string();
    try {
      logs.push_back(entryOf(loadLog(files, file), file, declared, of_log));
      if (missing.empty()) missing = of_log;
    } catch (const BadInput& reason) {
      out.unusable.emplace_back(reason.what());
    }
  }
  if (logs.empty()) refuseUnusable(out);
  if (request.model.empty()) missing += declared.missingOfServo();
  if (!missing.empty()) throw BadInput(request.folder + messages::kNotDeclared + missing);

  Case& head = out.given;
  head.name = nameOfFolder(request.folder);
  head.model = model;
  head.priors = benchPriors();
  head.pendulum = {.payload_kg = 0, .arm_mass_kg = logs[0]["arm_mass_kg"], .length_m = logs[0]["length_m"]};
  Json whole = parseJson(caseAsJson(head, !fitsBaseline(head)), "declared");
  for (Json& entry : logs) entry["role"] = "fit";  // until holdOut()
  whole["logs"] = logs;
  readDeclared(whole.dump(), declared, files, out);
  if (!declared.text("goal_order"))
    out.notes.emplace_back(
        "a goal counts as written right after the read of its row; else --declare goal_order=before_read");
  return out;
}

}  // namespace darwinop::gap
