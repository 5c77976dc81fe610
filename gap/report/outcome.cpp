#include "gap/report/outcome.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "gap/data/data_check.hpp"
#include "gap/name/judge.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/model_text.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

/// More digits than any fit knows, and few enough to be read. Counts and seeds stay.
double forReading(double value) {
  if (value == std::round(value)) return value;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

std::vector<std::string> reasonsFor(const Case& given, const Naming& naming, const Found& found,
                                    const std::string& data_hash) {
  std::vector<std::string> lines{"Found by darwinop gap in the logs of case " + given.name +
                                 ": without it the fit is worse by " + rounded(found.gain)};
  if (std::isfinite(naming.threshold))
    lines.front() += "; " + rounded(naming.threshold) + " comes by chance once in a hundred cases";
  if (naming.verdict == Verdict::kUnknown)
    lines.emplace_back("It helps, and leaves a gap that no known effect explains");
  if (naming.remains) lines.emplace_back("Something else is left in these logs that no known effect explains");
  if (naming.verdict == Verdict::kAmbiguous && &found == &naming.found.back())
    for (const Rival& rival : closeRivals(naming))
      lines.push_back("Not certain: " + joined(rival.effects, " + ") + " explains the logs nearly as well");
  if (!data_hash.empty()) lines.push_back("sha256 of the data: " + data_hash);
  return lines;
}

const Estimate* estimateOf(const Found& found, std::string_view key) {
  for (const Estimate& estimate : found.estimates)
    if (estimate.name.substr(estimate.name.find('.') + 1) == key) return &estimate;
  return nullptr;
}

bool isFound(const Naming& naming, const twin::EffectInfo* effect) {
  for (const Found& found : naming.found)
    if (found.effect == effect) return true;
  return false;
}

/// Numbers of effects that the baseline has already.
void addMovedEffects(const Hypothesis& before, const Naming& naming, Additions& into) {
  for (const twin::EffectSetting& was : before.effects) {
    const twin::EffectSetting* const now = naming.model.find(was.info->id);
    if (now == nullptr || isFound(naming, was.info)) continue;
    for (std::size_t i = 0; i < was.values.size(); ++i)
      if (was.values[i] != now->values[i])
        into.numbers.push_back(
            {std::string{was.info->id} + "." + std::string{was.info->parameters[i].key}, forReading(now->values[i])});
  }
}

}  // namespace

Outcome investigate(const Case& given, const NameOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome;
  options.tell("1 of 3: looking where the gap is");
  outcome.where = locate(given, evidenceOf(given, baselineOf(given)));
  NameOptions second = options;
  second.tell = [&](const std::string& what) { options.tell("2 of 3: " + what); };
  Naming naming = nameEffects(given, second);
  options.tell("3 of 3: before and after on the kept logs");
  outcome.score_before_rad = gapOf(given, baselineOf(given), true);
  outcome.score_after_rad = gapOf(given, naming.model, true);
  if (naming.verdict == Verdict::kUnknown || naming.remains) {
    const Case left = withModel(given, naming.model);
    outcome.remains = whatRemains(locate(left, evidenceOf(left, naming.model)));
    for (const Finding& finding : checkData(given).findings)
      if (finding.id == "kept_load" && !finding.reveals) outcome.remains += " " + finding.sentence;
  }
  outcome.naming = std::move(naming);
  outcome.runtime_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

Additions additionsOf(const Case& given, const Outcome& outcome, const std::string& data_hash) {
  const Naming& naming = outcome.naming;
  const Hypothesis before = baselineOf(given);
  Additions additions;
  for (const MovedNumber& moved : movedNumbers(before.servo, naming.model.servo))
    additions.numbers.push_back({moved.key, forReading(moved.after)});
  addMovedEffects(before, naming, additions);
  for (const Found& found : naming.found) {
    const twin::EffectSetting* const setting = naming.model.find(found.effect->id);
    if (setting == nullptr) continue;
    AddedEffect effect{std::string{found.effect->id}, {}, reasonsFor(given, naming, found, data_hash)};
    for (std::size_t i = 0; i < setting->values.size(); ++i) {
      AddedValue value{std::string{found.effect->parameters[i].key}, forReading(setting->values[i]), std::nan(""),
                       std::nan("")};
      const Estimate* const estimate = estimateOf(found, value.key);
      if (estimate != nullptr && !estimate->seen)
        effect.because.push_back(value.key + ": these data say nothing about it");
      else if (estimate != nullptr)
        value.low = estimate->low, value.high = estimate->high;
      effect.values.push_back(value);
    }
    additions.effects.push_back(std::move(effect));
  }
  return additions;
}

std::string caseModel(const Case& given) {
  twin::Model model = given.model;
  if (model.name.empty()) model.name = given.name;
  return twin::writeModel(model);
}

std::string repairedModel(const Case& given, const Outcome& outcome) {
  return withAdditions(caseModel(given), additionsOf(given, outcome, dataHash(given)));
}

}  // namespace darwinop::gap
