#include "gap/report/body/body_report.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/json/json_text.hpp"
#include "gap/report/addition.hpp"
#include "gap/report/body/body_additions.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/report_folder.hpp"
#include "gap/report/results.hpp"

namespace darwinop::gap {

std::string dataHash(const BodyCase& given) {
  std::vector<std::string> files{"case.json"};
  for (const BodyLog& log : given.logs)
    if (std::ranges::find(files, log.file) == files.end()) files.push_back(log.file);
  return dataHash(given.folder, files);
}

BodyReport reportOf(const BodyCase& given, const BodyIdentification& found, const std::string& model) {
  BodyReport report;
  report.given = &given;
  report.found = &found;
  report.answer["format"] = kResultsFormat;
  report.answer.update(asJson(given, found));
  report.answer[kModelHash] = sha256(model);
  report.answer[kDataHash] = dataHash(given);
  report.model_before = report.model_after = model;
  if (report.answer["effects"].empty()) return report;
  const BodyAdditions added =
      bodyAdditionsIn(report.answer.dump(), "the result", given.name, twin::parseModel(model, "the model"));
  report.model_after = withAdditions(model, added.additions);
  report.left_out = added.left_out;
  return report;
}

std::vector<OpenSignal> openSignals(const BodyReport& report) {
  const nlohmann::ordered_json& remainder = report.answer["remainder"];
  std::vector<std::string> left;
  if (!remainder.is_null()) left = remainder["signals"].get<std::vector<std::string>>();
  std::vector<OpenSignal> out;
  for (const nlohmann::ordered_json& row : report.answer["where"]) {
    const auto signal = row["signal"].get<std::string>();
    if (report.found->verdict == Verdict::kUnknown || std::ranges::find(left, signal) != left.end())
      out.push_back({signal, row["block"].get<std::string>()});
  }
  return out;
}

nlohmann::ordered_json asJson(const BodyReport& report) {
  nlohmann::ordered_json all = report.answer;
  all.erase("runtime_s");
  return all;
}

void writeReport(const BodyReport& report, const std::string& folder) {
  writeReportFolder(folder, {{"report.html", asHtml(report)},
                             {"report.json", jsonText(asJson(report), 1) + "\n"},
                             {"repaired.ini", report.model_after}});
}

}  // namespace darwinop::gap
