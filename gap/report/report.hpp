// The report: HTML page, report.json, repaired.ini.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/report/results.hpp"

namespace darwinop::gap {

struct Report {
  const Case* given = nullptr;
  const Outcome* outcome = nullptr;  // null: nothing was searched, two models were compared
  Comparison comparison;
  std::string model_before, model_after;  // model files
  std::string data_hash;                  // empty: the case lies in no folder
  std::vector<std::string> commands;      // that make this report again
};

/// Of a run; both have to outlive it. `model`: the file that the case's model is from, whose comments stay; empty:
/// none.
Report reportOf(const Case& given, const Outcome& outcome, const std::string& model = {});
/// Of two models on the logs of a case. Model files; throws std::runtime_error for one that cannot be read.
Report reportOn(const Case& given, const std::string& before, const std::string& after);

/// One file that needs no other and no network. The same report, the same bytes.
std::string asHtml(const Report& report);
/// What asJson() has for a run, and the figures of the page; docs/gap/report.md. Deterministic: no times.
nlohmann::json asJson(const Report& report);
/// For a terminal, at most 24 lines.
std::string asText(const Report& report);

/// The case with another model: that file's servo, and its effects for all joints or that of the case. The bench stays.
Case withModel(Case given, const twin::Model& model);

/// Writes report.html, report.json and repaired.ini into `folder`, which is made. Throws std::runtime_error with a
/// sentence when it cannot.
void writeReport(const Report& report, const std::string& folder);

}  // namespace darwinop::gap
