// A folder of raw logs as a case: BAM's JSON files or CSVs, without a case.json. What the logs do not contain is
// declared as KEY=VALUE.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gap/case/declarations.hpp"

namespace darwinop::gap {

namespace messages {
inline constexpr const char* kNeitherCaseNorLogs =
    " has neither a case.json nor logs: CSVs, or the JSON files of BAM; docs/gap/cases.md explains a case, and "
    "docs/gap/own-servo.md raw logs";
}  // namespace messages

/// kByFiles: BAM if any JSON has `entries`, or if there is no CSV.
enum class RawFormat : std::uint8_t { kByFiles, kBam, kCsv };

struct RawFolder {
  std::string folder;
  std::string model;                  // model file, or name of a shipped model; empty: the servo is declared
  std::vector<std::string> declared;  // "kp=100"
  std::vector<std::string> held_out;  // names of logs, without their ending
  bool all_logs = false;              // also of a large folder
  RawFormat format = RawFormat::kByFiles;
};

/// A case, and what was recognized in its logs or assumed, in sentences.
struct FolderCase {
  Case given;
  std::vector<std::string> notes;
  std::string motor = {};                  // as the logs name it: "mx106"
  std::vector<std::string> unusable = {};  // why a log is not in the case, a sentence each
};

/// True: no case.json, but at least one *.json or *.csv.
bool isRawFolder(const std::string& folder);

/// Throws BadInput that lists all that is missing. Logs that cannot be used are left out and noted, see noteUnusable();
/// of a large folder some are chosen.
FolderCase readRawFolder(const RawFolder& request);
/// CSVs of a servo of `model`. A column `kp`, `payload_kg`, `arm_mass_kg`, `length_m` or `supply_V` with one value
/// counts before a declaration.
FolderCase readCsvFolder(const RawFolder& request, const Declarations& declared, const twin::Model& model);

/// Logs that are fitted at least, where there are as many: a motor that is roughly known needs three to name an effect
/// (CrossValidation::improves).
inline constexpr std::size_t kFewestFitted = 3;

/// Notes each log that is left out. Throws BadInput, with the reasons, if that is more than half of the files, or if
/// fewer than kFewestFitted remain of a folder that loses more than a tenth.
void noteUnusable(FolderCase& in);
/// No log is left.
[[noreturn]] void refuseUnusable(const FolderCase& in);

/// Marks logs as held out: those with these names; without any, those of the greatest P gain if they are at most half,
/// else the last quarter, rounded up; so that kFewestFitted remain where there are as many. Throws BadInput for a name
/// without a log, and if none is left to fit.
void holdOut(const std::vector<std::string>& names, FolderCase& in);

/// Most logs that are searched, of each role. Of an XL330, 8 and 4 took 145 core-seconds, 16 and 8 took 298; the goal
/// is two minutes on two cores.
inline constexpr std::size_t kMostFitLogs = 12, kMostHeldOutLogs = 6;
/// The same in seconds of logs, for long ones; beyond, only the fewest logs are taken.
inline constexpr double kMostFitSeconds = 80, kMostHeldOutSeconds = 40;
inline constexpr std::size_t kFewestChosen = 4, kFewestHeldOut = 2;  // BAM has four motions
/// So many logs are searched for hours, as each is left out in turn: --all-logs is warned of.
inline constexpr std::size_t kManyLogs = 40;
/// Moves what exceeds that to the others of the case: kept are those that differ most in bench, gain and goals.
void chooseLogs(FolderCase& in);
/// The note on a search of all logs; nothing up to kManyLogs.
void noteAllLogs(FolderCase& in);

/// How well a data sheet and a scale know a bench: the maker's torque to a tenth, winding and gear worse.
std::vector<Prior> benchPriors();

}  // namespace darwinop::gap
