#include "gap/report/report.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/json/json_text.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/write_instant.hpp"
#include "gap/plants.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/report_folder.hpp"

namespace darwinop::gap {

Report reportOf(const Case& given, const Outcome& outcome, const std::string& model) {
  Report report;
  report.given = &given;
  report.outcome = &outcome;
  report.comparison = compare(given, outcome.baseline, outcome.identification.model);
  report.model_before = model.empty() ? caseModel(given) : model;
  report.data_hash = dataHash(given);
  report.model_after = withAdditions(report.model_before, additionsOf(given, outcome, report.data_hash));
  return report;
}

namespace {

/// A model file does not say when goals were written. Where no log says it either: as the fitted logs are predicted
/// best.
Hypothesis asWritten(const Case& given) {
  constexpr int kSteps = 20;  // a row of 10 ms: 0.5 ms
  Hypothesis best = baselineOf(given);
  const double longest_s = longestWriteTime(given);
  if (longest_s == 0) return best;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= kSteps; ++step) {
    Hypothesis one = best;
    one.written_before_s = longest_s * step / kSteps;
    const double error = rmsPositionError(plantOf(given), given, one, LogRole::kFit);
    if (error < least) least = error, best = one;
  }
  return best;
}

}  // namespace

Report reportOn(const Case& given, const std::string& before, const std::string& after) {
  Report report;
  report.given = &given;
  const Case old_case = withModel(given, twin::parseModel(before, "the model before"));
  const Case new_case = withModel(given, twin::parseModel(after, "the model after"));
  report.comparison = compare(given, asWritten(old_case), asWritten(new_case));
  report.model_before = before;
  report.model_after = after;
  report.data_hash = dataHash(given);
  return report;
}

Case withModel(Case given, const twin::Model& model) {
  given.model = model;
  given.model.effects = servoEffects(model, given.joint);
  // A number that the model does not have needs no prior.
  std::erase_if(given.priors, [&](const Prior& prior) {
    const std::size_t dot = prior.number.find('.');
    return dot != std::string::npos && std::ranges::none_of(given.model.effects, [&](const auto& effect) {
             return effect.info->id == prior.number.substr(0, dot);
           });
  });
  return given;
}

void writeReport(const Report& report, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files{{"report.html", asHtml(report)},
                                                         {"report.json", jsonText(asJson(report), 1) + "\n"}};
  if (report.outcome != nullptr) files.emplace_back("repaired.ini", report.model_after);
  writeReportFolder(folder, files);
}

}  // namespace darwinop::gap
