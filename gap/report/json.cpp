// What programs read.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gap/name/judge.hpp"
#include "gap/report/outcome.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

json mradOrNull(double rad) {
  return std::isfinite(rad) ? json(mradOf(rad)) : json(nullptr);
}

json opensOrNull(const Outcome& outcome) {
  return outcome.where.blocks.first ? json(name(*outcome.where.blocks.first)) : json(nullptr);
}

/// A fit to all logs knows better than a cut through the loop.
json blockOrNull(const Outcome& outcome) {
  const Naming& naming = outcome.naming;
  if (naming.verdict != Verdict::kNamed || naming.found.empty()) return opensOrNull(outcome);
  return name(blockOf(naming.found.front().effect->place));
}

json parametersOf(const Additions& additions, const Found& found) {
  json parameters = json::object(), intervals = json::object(), in_model = json::object();
  for (const Estimate& estimate : found.estimates) {
    const std::string key = estimate.name.substr(estimate.name.find('.') + 1);
    parameters[key] = estimate.value;
    intervals[key] = {estimate.low, estimate.high};
  }
  for (const AddedEffect& added : additions.effects)
    if (added.id == found.effect->id)
      for (const AddedValue& value : added.values) in_model[value.key] = value.value;
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

/// What the fit moved of the bench, which no model file holds.
json benchOf(const Case& given, const Naming& naming) {
  return {{"payload_factor", naming.model.payload_scale},
          {"length_factor", naming.model.pendulum.length_m / given.pendulum.length_m}};
}

}  // namespace

json asJson(const Case& given, const Outcome& outcome) {
  const Naming& naming = outcome.naming;
  const Additions additions = additionsOf(given, outcome, "");
  json effects = json::array(), ambiguity = json::array();
  // What only helps is not named.
  if (naming.verdict != Verdict::kUnknown)
    for (const Found& found : naming.found) effects.push_back(parametersOf(additions, found));
  if (naming.verdict == Verdict::kAmbiguous) {
    json set = json::array();
    if (!naming.found.empty()) set.push_back(naming.found.back().effect->id);
    for (const Rival& rival : naming.rivals)
      if (rival.isClose() && !rival.effects.empty() && set.size() < 3) set.push_back(rival.effects.back());
    ambiguity.push_back(set);
  }
  json strained = json::array();
  for (const Strained& one : naming.strained)
    strained.push_back({{"number", one.number}, {"sigma", one.sigmas}, {"factor", one.factor}});
  json doubted = json::array();
  constexpr std::array<std::string_view, 4> kWhy{"voltage", "undecided", "foretells_nothing", "worsens_kept"};
  for (const Doubted& one : naming.doubted)
    doubted.push_back({{"id", one.effect->id}, {"why", kWhy.at(static_cast<std::size_t>(one.why))}});
  return {{"case", given.name},
          {"verdict", nameOf(naming.verdict)},
          {"effects", effects},
          {"ambiguity", ambiguity},
          {"where", asJson(outcome.where)["places"]},
          {"block", blockOrNull(outcome)},
          {"opens", opensOrNull(outcome)},
          {"remains", outcome.remains},
          {"doubted", doubted},
          {"strained", strained},
          {"numbers", numbersOf(additions)},
          {"bench", benchOf(given, naming)},
          {"misfit_sigma", naming.misfit},
          {"threshold", std::isfinite(naming.threshold) ? json(naming.threshold) : json(nullptr)},
          {"gap_fit_before_mrad", mradOrNull(naming.gap_before_rad)},
          {"gap_fit_after_mrad", mradOrNull(naming.gap_after_rad)},
          {"floor_fit_mrad", mradOrNull(naming.floor_rad)},
          {"gap_score_before_mrad", mradOrNull(outcome.score_before_rad)},
          {"gap_score_after_mrad", mradOrNull(outcome.score_after_rad)},
          {"mean_error_score_before_mrad", mradOrNull(meanErrorOf(given, baselineOf(given), true))},
          {"mean_error_score_after_mrad", mradOrNull(meanErrorOf(given, naming.model, true))},
          {"warnings", given.warnings},
          {"runtime_s", std::round(outcome.runtime_s * 10) / 10}};
}

json badInput(const std::string& name, const std::string& why) {
  return {{"case", name},
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
