#include "gap/report/results.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> reasonsFor(const Case& given, const Identification& identification,
                                    const IdentifiedEffect& found, const std::string& data_hash) {
  std::vector<std::string> lines{"Found by darwinop gap in the logs of case " + given.name +
                                 ": without it the fit is worse by " + text::fixedText(found.gain, 0)};
  if (std::isfinite(identification.threshold))
    lines.front() += "; " + text::fixedText(identification.threshold, 0) + " is exceeded by chance in " +
                     chanceShare(identification) + " of cases";
  if (identification.verdict == Verdict::kUnknown)
    lines.emplace_back("It improves the fit and leaves a gap that no further effect was found to explain");
  if (identification.remains)
    lines.emplace_back("These logs have a remainder that no further effect was found to explain");
  if (identification.verdict == Verdict::kAmbiguous && &found == &identification.effects.back())
    for (const Rival& rival : closeRivals(identification))
      lines.push_back("Not certain: " + text::joined(rival.effects, " + ") + " explains the logs nearly as well");
  if (!data_hash.empty()) lines.push_back("sha256 of the data: " + data_hash);
  return lines;
}

const Estimate* estimateOf(const IdentifiedEffect& found, std::string_view key) {
  for (const Estimate& estimate : found.estimates)
    if (estimate.name.substr(estimate.name.find('.') + 1) == key) return &estimate;
  return nullptr;
}

bool isFound(const Identification& identification, const twin::EffectInfo* effect) {
  for (const IdentifiedEffect& found : identification.effects)
    if (found.effect == effect) return true;
  return false;
}

/// Numbers of effects that the baseline has already.
void addMovedEffects(const Hypothesis& before, const Identification& identification, Additions& into) {
  for (const twin::EffectSetting& was : before.effects) {
    const twin::EffectSetting* const now = identification.model.find(was.info->id);
    if (now == nullptr || isFound(identification, was.info)) continue;
    for (std::size_t i = 0; i < was.values.size(); ++i)
      if (was.values[i] != now->values[i])
        into.numbers.push_back(
            {std::string{was.info->id} + "." + std::string{was.info->parameters[i].key}, forReading(now->values[i])});
  }
}

}  // namespace

Additions additionsOf(const Case& given, const Outcome& outcome, const std::string& data_hash) {
  const Identification& identification = outcome.identification;
  const Hypothesis& before = outcome.baseline;
  Additions additions;
  for (const MovedNumber& moved : movedNumbers(before.servo, identification.model.servo))
    additions.numbers.push_back({moved.key, forReading(moved.after)});
  addMovedEffects(before, identification, additions);
  for (const IdentifiedEffect& found : identification.effects) {
    const twin::EffectSetting* const setting = identification.model.find(found.effect->id);
    if (setting == nullptr) continue;
    AddedEffect effect{std::string{found.effect->id}, {}, reasonsFor(given, identification, found, data_hash)};
    for (std::size_t i = 0; i < setting->values.size(); ++i) {
      AddedValue value{std::string{found.effect->parameters[i].key}, forReading(setting->values[i]), std::nan(""),
                       std::nan("")};
      const Estimate* const estimate = estimateOf(found, value.key);
      if (estimate != nullptr && !estimate->seen)
        effect.because.push_back(value.key + ": " + std::string{messages::kNotIdentifiable});
      else if (estimate != nullptr)
        value.setInterval(estimate->low, estimate->high, value.value - estimate->value);
      effect.values.push_back(value);
    }
    additions.effects.push_back(std::move(effect));
  }
  return atJoint(std::move(additions), given);
}

std::string caseModel(const Case& given) {
  twin::Model model = given.model;
  if (model.name.empty()) model.name = given.name;
  return twin::writeModel(model);
}

}  // namespace darwinop::gap
