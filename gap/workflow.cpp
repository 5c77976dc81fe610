#include "gap/workflow.hpp"

#include <chrono>

#include "gap/case/data_check.hpp"
#include "gap/plant/position_error.hpp"

namespace darwinop::gap {
namespace {

using Clock = std::chrono::steady_clock;

/// `options` whose progress texts begin with `prefix`.
IdentifyOptions withPrefix(const IdentifyOptions& options, const std::string& prefix) {
  IdentifyOptions with = options;
  with.progress = [&options, prefix](const std::string& text) { options.progress(prefix + text); };
  return with;
}

/// Error on the held-out logs, before and after.
Verification verify(const Study& study, const Hypothesis& model) {
  return {.rms_before_rad = rmsPositionError(study.plant, study.data, study.baseline, LogRole::kHeldOut),
          .rms_after_rad = rmsPositionError(study.plant, study.data, model, LogRole::kHeldOut),
          .mean_before_rad = meanPositionError(study.plant, study.data, study.baseline, LogRole::kHeldOut),
          .mean_after_rad = meanPositionError(study.plant, study.data, model, LogRole::kHeldOut)};
}

/// Localizes the remaining gap of the final model. Empty: no gap remains.
std::string remainderOf(const Case& data, const DataCheck& check, const Identification& found) {
  if (found.verdict != Verdict::kUnknown && !found.remains) return "";
  const Case with_model = withModel(data, found.model);
  std::string text = describeRemainder(localize(Study{with_model}));
  for (const DataFinding& finding : check.findings)
    if (finding.id == kHeldOutLoadFinding && !finding.reveals) text += " " + finding.sentence;
  return text;
}

}  // namespace

Outcome investigate(const Case& data, const IdentifyOptions& options) {
  const Clock::time_point begin = Clock::now();
  Outcome outcome;

  options.progress("1 of 3: localizing the gap");
  const DataCheck check = checkData(data);
  const Study study{data};
  outcome.baseline = study.baseline;
  outcome.localization = localize(study);

  outcome.identification = identify(study, withPrefix(options, "2 of 3: "));

  options.progress("3 of 3: error on held-out logs before and after");
  outcome.verification = verify(study, outcome.identification.model);
  outcome.remainder = remainderOf(data, check, outcome.identification);

  outcome.runtime_s = std::chrono::duration<double>(Clock::now() - begin).count();
  return outcome;
}

}  // namespace darwinop::gap
