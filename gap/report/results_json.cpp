// results.json: one object a case.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gap/case/contradictions.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/report/joint_numbers.hpp"
#include "gap/report/results.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

json mradOrNull(double rad) {
  return std::isfinite(rad) ? json(mradOf(rad)) : json(nullptr);
}

json firstOpenBlockOrNull(const Outcome& outcome) {
  return outcome.localization.blocks.first ? json(name(*outcome.localization.blocks.first)) : json(nullptr);
}

/// A fit to all logs is more certain than a block residual.
json blockOrNull(const Outcome& outcome) {
  const Identification& identification = outcome.identification;
  if (identification.verdict != Verdict::kNamed || identification.effects.empty()) return firstOpenBlockOrNull(outcome);
  return name(blockOf(identification.effects.front().effect->part));
}

/// What was found, and the same as the model file has it: numbers of a joint's servo are in effects of that joint.
struct Written {
  Additions found, in_model;
};

/// A number of the servo is in the value that the model file has, so that the interval is not of this value.
void dropMergedIntervals(const AddedEffect& found, const AddedEffect& in_model, json& intervals) {
  for (const AddedValue& value : in_model.values) {
    const auto was = std::ranges::find(found.values, value.key, &AddedValue::key);
    if (was != found.values.end() && was->value != value.value && intervals.contains(value.key))
      intervals[value.key] = {nullptr, nullptr};
  }
}

json valuesOf(const AddedEffect& added) {
  json values = json::object();
  for (const AddedValue& value : added.values) values[value.key] = value.value;
  return values;
}

json parametersOf(const Written& written, const IdentifiedEffect& found) {
  json parameters = json::object(), intervals = json::object(), in_model = json::object();
  for (const Estimate& estimate : found.estimates) {
    const std::string key = estimate.name.substr(estimate.name.find('.') + 1);
    parameters[key] = estimate.value;
    intervals[key] = {estimate.low, estimate.high};
  }
  const auto was = std::ranges::find(written.found.effects, found.effect->id, &AddedEffect::id);
  const auto now = std::ranges::find(written.in_model.effects, found.effect->id, &AddedEffect::id);
  if (was != written.found.effects.end() && now != written.in_model.effects.end()) {
    in_model = valuesOf(*now);
    dropMergedIntervals(*was, *now, intervals);
  }
  return {{"id", found.effect->id},
          {"params", parameters},
          {"interval_90", intervals},
          {"in_model", in_model},
          {"gain", found.gain}};
}

json numbersOf(const Additions& additions) {
  json numbers = json::array();
  for (const AddedNumber& number : additions.numbers)
    numbers.push_back({{"number", number.key}, {"after", number.value}});
  return numbers;
}

/// Effects that only stand for numbers that the fit moved.
json movedOf(const Written& written) {
  json moved = json::array();
  for (const AddedEffect& added : written.in_model.effects)
    if (std::ranges::find(written.found.effects, added.id, &AddedEffect::id) == written.found.effects.end())
      moved.push_back({{"id", added.id}, {"in_model", valuesOf(added)}, {"because", added.because}});
  return moved;
}

/// What the fit moved of the bench, which no model file holds.
json benchOf(const Case& given, const Identification& identification) {
  json bench = {{"payload_factor", identification.model.payload_scale},
                {"length_factor", identification.model.pendulum.length_m / given.pendulum.length_m}};
  if (const auto time_s = foundWriteTime(given, identification)) bench["written_before_s"] = *time_s;
  return bench;
}

json contradictionsAsJson(const Case& given) {
  json all = json::array();
  for (const Contradiction& found : contradictionsOf(given))
    all.push_back({{"number", found.number},
                   {"model", found.model},
                   {"measured", found.measured},
                   {"unit", found.unit},
                   {"logs", found.logs},
                   {"of", found.of}});
  return all;
}

/// Readings that count nowhere, by log and column.
json maskedOf(const Case& given) {
  json all = json::array();
  for (const Trajectory& log : given.logs)
    for (const MaskedReadings& masked : log.masked)
      all.push_back({{"file", log.file},
                     {"column", masked.column},
                     {"rows", masked.rows},
                     {"of", log.rows()},
                     {"first_line", masked.first_line},
                     {"why", masked.why}});
  return all;
}

}  // namespace

json asJson(const Case& given, const Outcome& outcome) {
  const Identification& identification = outcome.identification;
  const Additions found_alone = additionsOf(given, outcome, "");
  const Written written{found_alone, withJointNumbers(found_alone, given.model)};
  json effects = json::array(), candidates = json::array(), ambiguity = json::array();
  // In `unknown` the effects only improve the fit.
  json& listed = identification.verdict == Verdict::kUnknown ? candidates : effects;
  for (const IdentifiedEffect& found : identification.effects) listed.push_back(parametersOf(written, found));
  for (const IdentifiedEffect& tried : identification.withdrawn) candidates.push_back(parametersOf(written, tried));
  if (identification.verdict == Verdict::kAmbiguous) {
    json set = json::array();
    for (const twin::EffectInfo* const effect : undecidedEffects(identification))
      if (set.size() < 3) set.push_back(effect->id);
    ambiguity.push_back(set);
  }
  json conflicts = json::array();
  for (const PriorConflict& one : identification.prior_conflicts)
    conflicts.push_back({{"number", one.number}, {"sigma", one.sigmas}, {"factor", one.factor}});
  json rejected = json::array();
  for (const RejectedEffect& one : identification.rejected)
    rejected.push_back({{"id", one.effect->id}, {"why", nameOf(one.why)}});
  return {{"format", kResultsFormat},
          {"case", given.name},
          {"verdict", nameOf(identification.verdict)},
          {"effects", effects},
          {"candidates", candidates},
          {"ambiguity", ambiguity},
          {"where", asJson(outcome.localization)["places"]},
          {"block", blockOrNull(outcome)},
          {"first_open_block", firstOpenBlockOrNull(outcome)},
          {"remainder", outcome.remainder},
          {"explained_logs", identification.explained},
          {"rejected", rejected},
          {"prior_conflicts", conflicts},
          {"numbers", numbersOf(written.in_model)},
          {"moved", movedOf(written)},
          {"bench", benchOf(given, identification)},
          {"misfit_sigma", identification.misfit},
          {"threshold", std::isfinite(identification.threshold) ? json(identification.threshold) : json(nullptr)},
          {"gap_fit_before_mrad", mradOrNull(identification.gap_before_rad)},
          {"gap_fit_after_mrad", mradOrNull(identification.gap_after_rad)},
          {"repeats_mrad", mradOrNull(outcome.localization.floor.repeats_rad)},
          {"floor_fit_mrad", mradOrNull(identification.floor_rad)},
          {"gap_score_before_mrad", mradOrNull(outcome.verification.rms_before_rad)},
          {"gap_score_after_mrad", mradOrNull(outcome.verification.rms_after_rad)},
          {"mean_error_held_out_before_mrad", mradOrNull(outcome.verification.mean_before_rad)},
          {"mean_error_held_out_after_mrad", mradOrNull(outcome.verification.mean_after_rad)},
          {"contradictions", contradictionsAsJson(given)},
          {"masked", maskedOf(given)},
          {"warnings", given.warnings},
          {"runtime_s", std::round(outcome.runtime_s * 10) / 10}};
}

json badInput(const std::string& name, const std::string& why) {
  return {{"format", kResultsFormat},
          {"case", name},
          {"verdict", nameOf(Verdict::kBadInput)},
          {"effects", json::array()},
          {"ambiguity", json::array()},
          {"where", json::array()},
          {"why", why},
          {"gap_score_before_mrad", nullptr},
          {"gap_score_after_mrad", nullptr},
          {"runtime_s", 0}};
}

}  // namespace darwinop::gap
