// The checks of a case's logs, on BAM logs: reasons name the JSON file and its entry, not a CSV.
#include <algorithm>
#include <filesystem>

#include "experiments/logs/read_log.hpp"
#include "gap/case/bam_log.hpp"
#include "gap/case/declared_case.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

constexpr std::string_view kLine = ".json, line ";
constexpr std::string_view kOtherColumnName = "name the column";  // of a CSV, by its unit

/// "a.json, line 7: ..." as "a.json, entries[7]: ...".
std::string ofEntry(std::string reason) {
  if (const std::size_t at = reason.find(kLine); at != reason.npos) {
    const std::size_t number = at + kLine.size();
    reason.insert(std::min(reason.find_first_not_of("0123456789", number), reason.size()), "]");
    reason.replace(at, kLine.size(), ".json, entries[");
  }
  return reason.find(kOtherColumnName) == reason.npos ? reason : reason + messages::kKeysHaveUnits;
}

}  // namespace

void checkBamLogs(const Declarations& declared, FolderCase& in) {
  const Case logs = in.given;
  const auto asLog = [&](const std::string& name) {
    const auto of = std::ranges::find(logs.logs, name, &Trajectory::file);
    const auto source = (std::filesystem::path{logs.folder} / name).replace_extension(".json");
    logs::Log log = logs::parseLog(logAsCsv(*of), source.string());
    log.lines = of->lines;
    return log;
  };
  const std::size_t before = in.unusable.size();
  readDeclared(caseAsJson(logs, !fitsBaseline(logs)), declared, {.log = asLog, .model = {}}, in);
  for (std::size_t i = before; i < in.unusable.size(); ++i) in.unusable[i] = ofEntry(in.unusable[i]);
}

}  // namespace darwinop::gap
