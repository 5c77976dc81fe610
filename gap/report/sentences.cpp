#include "gap/report/sentences.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "gap/report/model_text.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kRivalsTold = 2;
constexpr double kNoChange = 0.02;  // share of a gap: less is no change to speak of

std::string titlesOf(const std::vector<Found>& found) {
  std::vector<std::string> titles;
  titles.reserve(found.size());
  for (const Found& one : found) titles.emplace_back(one.effect->title);
  if (titles.size() < 2) return joined(titles, "");
  const std::string last = titles.back();
  titles.pop_back();
  return joined(titles, ", ") + " and " + last;
}

/// "friction 0.0812 N m (9 in 10 sure: 0.0781 to 0.0853 N m)" of the first number of the first effect.
std::string firstNumber(const Naming& naming) {
  if (naming.found.size() != 1 || naming.found.front().estimates.empty()) return "";
  const Estimate& one = naming.found.front().estimates.front();
  std::string text = ": " + one.name.substr(one.name.find('.') + 1) + " " + withUnit(one.value, one.unit);
  if (!one.seen || !std::isfinite(one.low) || !std::isfinite(one.high)) return text;
  return text + ", with nine chances in ten between " + withUnit(one.low, "") + " and " + withUnit(one.high, one.unit);
}

std::string placeOf(const Outcome& outcome) {
  if (outcome.where.places.empty()) return "";
  const Place& place = outcome.where.places.front();
  char text[80];
  std::snprintf(text, sizeof text, "; it shows most between %.1f and %.1f s of ", place.t0_s, place.t1_s);
  return text + place.file;
}

std::string namedByRivals(const Naming& naming) {
  std::vector<std::string> titles{titlesOf(naming.found)};
  for (const Rival& rival : closeRivals(naming)) {
    if (titles.size() > kRivalsTold) {
      titles.emplace_back("others");
      break;
    }
    std::vector<std::string> parts;
    for (const std::string& id : rival.effects) {
      const twin::EffectInfo* const info = twin::findEffect(id);
      parts.push_back(info == nullptr ? id : std::string{info->title});
    }
    titles.push_back(joined(parts, " and "));
  }
  return joined(titles, ", or ");
}

std::string firstSentence(const Outcome& outcome) {
  const Naming& naming = outcome.naming;
  switch (naming.verdict) {
    case Verdict::kNone:
      return "The model explains these logs: what is left is noise.";
    case Verdict::kNamed:
      if (std::ranges::all_of(naming.found, &Found::corrected))
        return "The model has " + titlesOf(naming.found) + ", but with a wrong number" + firstNumber(naming) + ".";
      return "The model lacks " + titlesOf(naming.found) + firstNumber(naming) +
             (naming.remains ? "; something is left that none of the known effects explains." : ".");
    case Verdict::kAmbiguous:
      return "The model lacks something that these logs do not decide: " + namedByRivals(naming) + ".";
    case Verdict::kUnknown:
      return "The model lacks something that none of the " + std::to_string(twin::catalogue().size()) +
             " known effects explains" + placeOf(outcome) + ".";
    case Verdict::kCannotTell:
      return "These logs differ from the model, but by too little, or in too few ways, to say why.";
    case Verdict::kBadInput:
      break;
  }
  return "These logs cannot be used.";
}

}  // namespace

const std::string_view kBelowFloorSentence =
    "Below the floor: closer to these data than noise lets any model come. Either the servo is quieter than was "
    "assumed, or the log is no measurement of its own: a copy, or a simulation. Do not count it as a success.";

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : std::string{between}) + word;
  return text;
}

double mradOf(double rad) {
  return std::round(rad * 1e6) / 1e3;
}

std::string inMrad(double rad) {
  if (!std::isfinite(rad)) return "-";
  const double mrad = mradOf(rad);
  char text[32];
  std::snprintf(text, sizeof text, mrad < 9.995 ? "%.2f" : mrad < 99.95 ? "%.1f" : "%.0f", mrad);
  return text;
}

std::vector<Rival> closeRivals(const Naming& naming) {
  std::vector<Rival> close;
  for (const Rival& rival : naming.rivals)
    if (rival.isClose() && !rival.effects.empty()) close.push_back(rival);
  return close;
}

std::string shortDoubt(const Doubted& doubted) {
  const std::string id{doubted.effect->id};
  switch (doubted.why) {
    case Doubt::kVoltage:
      return id + ": fits, but the measured voltage does not dip as it would have to";
    case Doubt::kUndecided:
      return id + ": may be there, too; the report says which experiment decides";
    case Doubt::kWorsensKept:
      return id + ": fits these logs, and makes the kept ones worse";
    case Doubt::kForetellsNothing:
      break;
  }
  return id + ": fits these logs, and foretells no other";
}

std::string doubtSentence(const Doubted& doubted) {
  std::string title{doubted.effect->title};
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  switch (doubted.why) {
    case Doubt::kVoltage:
      return title + " would fit these logs better, but the measured voltage does not dip as it would have to.";
    case Doubt::kUndecided:
      break;
    case Doubt::kForetellsNothing:
      return title + " would fit these logs better, and foretells none that it has not seen.";
    case Doubt::kWorsensKept:
      return title + " would fit these logs better, and make the error on the kept ones greater by half or more.";
  }
  std::vector<std::string> doubles;
  for (const std::string_view id : doubted.effect->confused_with) doubles.emplace_back(twin::findEffect(id)->title);
  return title + " may be there, too, or one of its doubles (" + joined(doubles, ", ") +
         "): it foretells some of the logs better and others worse. What decides: " +
         std::string{doubted.effect->separated_by};
}

std::string helpSentence(const Comparison& comparison) {
  const Gap& gap = comparison.score;
  if (comparison.score_logs == 0)
    return "No log was kept for judging, so nothing here shows that a changed model would be better.";
  const std::string noise = "noise alone makes " + inMrad(gap.floor_rad) + ".";
  const std::string before = inMrad(gap.before_rad) + " mrad", after = inMrad(gap.after_rad) + " mrad";
  const std::string on = "On logs that no fit has seen, the position error ";
  const double change = (gap.after_rad - gap.before_rad) / gap.before_rad;
  if (std::abs(change) < kNoChange) return on + "is " + after + "; " + noise;
  if (change > 0) return on + "grows from " + before + " to " + after + ": do not use the changed model; " + noise;
  return on + "falls from " + before + " to " + after + "; " + noise;
}

std::vector<std::string> verdictSentences(const Outcome& outcome, const Comparison& comparison) {
  return {firstSentence(outcome), helpSentence(comparison)};
}

}  // namespace darwinop::gap
