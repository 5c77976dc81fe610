// The report for programs: what the page shows, in the same numbers.
#include <cmath>
#include <nlohmann/json.hpp>

#include "gap/report/data_hash.hpp"
#include "gap/report/joint_numbers.hpp"
#include "gap/report/line_diff.hpp"
#include "gap/report/report.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

/// As many digits as the page has.
json digits(double value, double unit) {
  return std::isfinite(value) ? json(std::round(value * unit) / unit) : json(nullptr);
}

json gapAsJson(const Gap& gap) {
  return {{"before_mrad", digits(gap.before_rad * 1e3, 1e3)},
          {"after_mrad", digits(gap.after_rad * 1e3, 1e3)},
          {"floor_mrad", digits(gap.floor_rad * 1e3, 1e3)},
          {"before_floors", digits(gap.floorsBefore(), 100)},
          {"after_floors", digits(gap.floorsAfter(), 100)}};
}

json othersAsJson(const Comparison& comparison) {
  json others = gapAsJson(comparison.others);
  others["median_after_mrad"] = digits(comparison.median_other_rad * 1e3, 1e3);
  others["worst_after_mrad"] = digits(comparison.worst_other_rad * 1e3, 1e3);
  others["worst_file"] = comparison.worst_other;
  return others;
}

json logsAsJson(const Report& report) {
  json logs = json::array();
  for (const LogComparison& one : report.comparison.logs) {
    const Trajectory& log = report.given->logs[one.log];
    json entry = gapAsJson(one.gap);
    entry["file"] = log.file;
    entry["trajectory"] = log.kind;
    entry["role"] = log.held_out ? "held_out" : "fit";
    entry["below_floor"] = one.below_floor;
    logs.push_back(entry);
  }
  return logs;
}

json diffAsJson(const Report& report) {
  json lines = json::array();
  for (const DiffLine& line : lineDiff(report.model_before, report.model_after))
    if (line.kind == '+' || line.kind == '-') lines.push_back(std::string{line.kind} + " " + line.text);
  return lines;
}

/// What the search found, without the time that it took, and with what each effect's comments say.
json searchAsJson(const Report& report) {
  json all = asJson(*report.given, *report.outcome);
  all.erase("runtime_s");
  const Additions additions =
      withJointNumbers(additionsOf(*report.given, *report.outcome, report.data_hash), report.given->model);
  for (json& effect : all["effects"])
    for (const AddedEffect& added : additions.effects)
      if (effect["id"] == added.id) effect["because"] = added.because;
  json rivals = json::array();
  for (const Rival& rival : report.outcome->identification.rivals)
    rivals.push_back({{"effects", rival.effects}, {"behind", rival.behind}, {"close", rival.isClose()}});
  all["rivals"] = rivals;
  all["sentences"] = verdictSentences(*report.outcome, report.comparison);
  return all;
}

}  // namespace

json asJson(const Report& report) {
  json all = report.outcome == nullptr
                 ? json{{"case", report.given->name}, {"sentences", {helpSentence(report.comparison)}}}
                 : searchAsJson(report);
  all["held_out"] = gapAsJson(report.comparison.held_out);
  all["fit"] = gapAsJson(report.comparison.fit);
  if (report.comparison.other_logs > 0) all["others"] = othersAsJson(report.comparison);
  all["logs"] = logsAsJson(report);
  all["model_changes"] = diffAsJson(report);
  all["commands"] = report.commands;
  all[kDataHash] = report.data_hash;
  return all;
}

std::string asText(const Report& report) {
  if (report.outcome != nullptr) return asText(*report.given, *report.outcome, report.comparison);
  return asText(*report.given, report.comparison);
}

}  // namespace darwinop::gap
