#include "gap/report/sentences.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/write_instant.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kSetsNamed = 4;

std::string listed(std::vector<std::string> titles) {
  if (titles.size() < 2) return text::joined(titles, "");
  const std::string last = titles.back();
  titles.pop_back();
  return text::joined(titles, ", ") + " and " + last;
}

std::string titlesOf(const std::vector<IdentifiedEffect>& found) {
  std::vector<std::string> titles;
  titles.reserve(found.size());
  for (const IdentifiedEffect& one : found) titles.emplace_back(one.effect->title);
  return listed(titles);
}

/// False: the interval contains the value with which the effect does nothing.
bool isActive(const twin::EffectInfo& effect, const Estimate& one) {
  const auto parameter =
      std::ranges::find(effect.parameters, one.name.substr(one.name.find('.') + 1), &twin::Parameter::key);
  return parameter == effect.parameters.end() || one.low > parameter->neutral || one.high < parameter->neutral;
}

/// "friction 0.0812 N m (9 in 10 sure: 0.0781 to 0.0853 N m)" of the first number of the first effect that shows.
std::string firstNumber(const Identification& identification) {
  if (identification.effects.size() != 1 || identification.effects.front().estimates.empty()) return "";
  const auto& estimates = identification.effects.front().estimates;
  const twin::EffectInfo& effect = *identification.effects.front().effect;
  const auto active = std::ranges::find_if(estimates, [&](const Estimate& each) { return isActive(effect, each); });
  const Estimate& one = active == estimates.end() ? estimates.front() : *active;
  std::string text = ": " + one.name.substr(one.name.find('.') + 1) + " " + withUnit(one.value, one.unit);
  if (!one.seen || !std::isfinite(one.low) || !std::isfinite(one.high)) return text;
  return text + ", with nine chances in ten between " + withUnit(one.low, "") + " and " + withUnit(one.high, one.unit);
}

std::string placeOf(const Outcome& outcome) {
  if (outcome.localization.places.empty()) return "";
  const GapInterval& place = outcome.localization.places.front();
  return "; it shows most between " + text::fixedText(place.t0_s, 1) + " and " + text::fixedText(place.t1_s, 1) +
         " s of " + place.file;
}

std::string titleOf(const std::string& id) {
  const twin::EffectInfo* const info = twin::findEffect(id);
  return info == nullptr ? id : std::string{info->title};
}

/// What the found effects and all close rivals have in common, and of each set the rest.
struct Alternatives {
  std::vector<std::string> shared;             // titles
  std::vector<std::vector<std::string>> rest;  // no two are equal; empty: that set has nothing else
};

Alternatives alternativesOf(const Identification& identification) {
  std::vector<std::vector<std::string>> sets(1);
  for (const IdentifiedEffect& found : identification.effects) sets.front().emplace_back(found.effect->id);
  for (const Rival& rival : closeRivals(identification)) sets.push_back(rival.effects);
  const auto is_shared = [&](const std::string& id) {
    return std::ranges::all_of(sets, [&](const auto& set) { return std::ranges::find(set, id) != set.end(); });
  };
  Alternatives out;
  for (const std::string& id : sets.front())
    if (is_shared(id)) out.shared.push_back(titleOf(id));
  for (const std::vector<std::string>& set : sets) {
    std::vector<std::string> titles;
    for (const std::string& id : set)
      if (!is_shared(id)) titles.push_back(titleOf(id));
    if (std::ranges::none_of(out.rest, [&](const auto& other) { return std::ranges::is_permutation(titles, other); }))
      out.rest.push_back(std::move(titles));
  }
  return out;
}

/// "dry friction, and these logs do not decide whether also torque limit", or "dry friction, and something that these
/// logs do not identify: torque limit, or joint flex and gear backlash".
std::string namedByRivals(const Identification& identification) {
  Alternatives sets = alternativesOf(identification);
  const bool maybe_none = std::erase_if(sets.rest, [](const auto& titles) { return titles.empty(); }) != 0;
  std::vector<std::string> names;
  for (const std::vector<std::string>& titles : sets.rest) names.push_back(listed(titles));
  if (names.size() > kSetsNamed) names.resize(kSetsNamed), names.emplace_back("others");
  if (maybe_none && !sets.shared.empty()) return listed(sets.shared) + messages::kPerhaps + text::joined(names, " or ");
  return (sets.shared.empty() ? "" : listed(sets.shared) + ", and ") + messages::kNotIdentified +
         text::joined(names, ", or ");
}

std::string firstSentence(const Outcome& outcome) {
  const Identification& identification = outcome.identification;
  const std::string end = identification.remains ? messages::kRemainder : ".";
  switch (identification.verdict) {
    case Verdict::kNone:
      return messages::kOnlyNoise;
    case Verdict::kNamed:
      if (std::ranges::all_of(identification.effects, &IdentifiedEffect::corrected))
        return "The model has " + titlesOf(identification.effects) + ", but with a wrong number" +
               firstNumber(identification) + end;
      return "The model lacks " + titlesOf(identification.effects) + firstNumber(identification) + end;
    case Verdict::kAmbiguous:
      return "The model lacks " + namedByRivals(identification) + end;
    case Verdict::kUnknown:
      return "The model lacks something that none of the " + std::to_string(twin::catalogue().size()) +
             messages::kOutsideCatalogue + placeOf(outcome) + ".";
    case Verdict::kCannotTell:
      return identification.too_few_logs ? messages::kTooFewLogs : messages::kTooLittle;
    case Verdict::kBadInput:
      break;
  }
  return "These logs cannot be used.";
}

}  // namespace

double mradOf(double rad) {
  return std::round(rad * 1e6) / 1e3;
}

std::string inMrad(double rad) {
  if (!std::isfinite(rad)) return "-";
  const double mrad = mradOf(rad);
  return text::fixedText(mrad, mrad < 9.995 ? 2 : mrad < 99.95 ? 1 : 0);
}

std::vector<Rival> closeRivals(const Identification& identification) {
  std::vector<Rival> close;
  for (const Rival& rival : identification.rivals)
    if (rival.isClose() && !rival.effects.empty()) close.push_back(rival);
  return close;
}

std::vector<const twin::EffectInfo*> undecidedEffects(const Identification& identification) {
  std::vector<const twin::EffectInfo*> undecided;
  const auto add = [&](const twin::EffectInfo* effect) {
    if (effect != nullptr && std::ranges::find(undecided, effect) == undecided.end()) undecided.push_back(effect);
  };
  const std::vector<Rival> close = closeRivals(identification);
  for (const IdentifiedEffect& found : identification.effects)
    if (std::ranges::any_of(close, [&](const Rival& rival) {
          return std::ranges::find(rival.effects, found.effect->id) == rival.effects.end();
        }))
      add(found.effect);
  const auto add_new = [&](const std::string& id) {
    if (std::ranges::find(identification.effects, id, [](const auto& one) { return one.effect->id; }) ==
        identification.effects.end())
      add(twin::findEffect(id));
  };
  // What makes it a rival is its last effect; others came along with that.
  for (const Rival& rival : close) add_new(rival.effects.back());
  for (const Rival& rival : close) std::ranges::for_each(rival.effects, add_new);
  return undecided;
}

std::string shortRejection(const RejectedEffect& rejected) {
  std::string id = std::string{rejected.effect->id} + ": ";
  switch (rejected.why) {
    case RejectionReason::kVoltage:
      return id.append(messages::kVoltage);
    case RejectionReason::kUndecided:
      return id.append(messages::kUndecided);
    case RejectionReason::kWorsensHeldOut:
      return id.append(messages::kWorsensHeldOut);
    case RejectionReason::kSmallShare:
      return id.append(messages::kSmallShare);
    case RejectionReason::kNoPredictiveGain:
      break;
  }
  return id.append(messages::kNoPredictiveGain);
}

std::string rejectionSentence(const RejectedEffect& rejected) {
  std::string title{rejected.effect->title};
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  switch (rejected.why) {
    case RejectionReason::kVoltage:
      return title.append(messages::kVoltageInFull);
    case RejectionReason::kUndecided:
      break;
    case RejectionReason::kNoPredictiveGain:
      return title.append(messages::kNoPredictiveGainInFull);
    case RejectionReason::kWorsensHeldOut:
      return title.append(messages::kWorsensHeldOutInFull);
    case RejectionReason::kSmallShare:
      return title.append(messages::kSmallShareInFull);
  }
  std::vector<std::string> doubles;
  for (const std::string_view id : rejected.effect->confused_with) doubles.emplace_back(twin::findEffect(id)->title);
  return title + " is possible, as are the effects it is confused with (" + text::joined(doubles, ", ") +
         "): on average it predicts other logs better, but by too little, or the logs disagree. Experiment that "
         "decides: " +
         std::string{rejected.effect->separated_by};
}

std::string intervalSentence(const Identification& identification) {
  if (!identification.remains) return "";
  if (identification.explained.empty()) return messages::kWidened;
  return messages::kExplained + text::joined(identification.explained, ", ") + ".";
}

std::optional<double> foundWriteTime(const Case& given, const Identification& identification) {
  const double time_s = identification.model.written_before_s;
  if (longestWriteTime(given) == 0 || time_s == baselineOf(given).written_before_s) return std::nullopt;
  return time_s;
}

std::string writeTimeSentence(const Case& given, const Identification& identification) {
  const std::optional<double> time_s = foundWriteTime(given, identification);
  return time_s ? text::formatted(messages::kWriteTime, text::fixedText(1e3 * *time_s, 1).c_str()) : "";
}

std::string triedSentence(const Identification& identification) {
  std::vector<std::string> values;
  for (const IdentifiedEffect& one : identification.withdrawn)
    for (const Estimate& estimate : one.estimates)
      values.push_back(estimate.name + " = " + withUnit(estimate.value, estimate.unit));
  return values.empty() ? "" : messages::kTried + text::joined(values, ", ") + ".";
}

std::string chanceShare(const Identification& identification) {
  if (identification.misfit < thresholds::kMisfitSigmas)
    return text::generalText(100 * IdentifyOptions{}.alpha, 2) + " %";
  // The threshold may be the greatest gain of the few replicas of a model that is plainly wrong.
  return "at most " + text::fixedText(std::ceil(200.0 / (thresholds::kFewBootstrapRuns + 1)) / 2, 1) + " %";
}

std::string helpSentence(const Comparison& comparison) {
  const Gap& gap = comparison.held_out;
  if (comparison.held_out_logs == 0)
    return std::string{messages::kNoHeldOutLog} + " Nothing here shows that a changed model is better.";
  const bool is_missed = gap.floorsAfter() > thresholds::kSmallRemainder;
  const std::string noise =
      "noise alone makes " + inMrad(gap.floor_rad) + (is_missed ? messages::kMissingThere : std::string{"."});
  const std::string before = inMrad(gap.before_rad) + " mrad", after = inMrad(gap.after_rad) + " mrad";
  const std::string on = "On held-out logs the position error ";
  const double change = (gap.after_rad - gap.before_rad) / gap.before_rad;
  if (std::abs(change) < thresholds::kUnchangedGapShare) return on + "is " + after + "; " + noise;
  if (isWorse(gap.before_rad, gap.after_rad, gap.floor_rad))
    return on + "grows from " + before + " to " + after + ": " + std::string{messages::kWorse} + "; " + noise;
  if (change > 0 && !(gap.after_rad - gap.before_rad < gap.floor_rad))
    return on + messages::kGrowsSlightly + before + " to " + after + "; " + noise;
  if (change > 0) return on + messages::kUnchanged + after + " after " + before + "; " + noise;
  return on + "falls from " + before + " to " + after + "; " + noise;
}

std::vector<std::string> verdictSentences(const Outcome& outcome, const Comparison& comparison) {
  return {firstSentence(outcome), helpSentence(comparison)};
}

}  // namespace darwinop::gap
