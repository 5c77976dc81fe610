// The summary on the terminal, about one screen.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "gap/case/contradictions.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "gap/report/results.hpp"
#include "gap/report/rival_text.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kEstimatesShown = 5, kRivalsShown = 2, kExperimentsShown = 2, kConflictsShown = 2,
                      kRejectedShown = 2;

/// In lines of a terminal, all but the first one after `indent`.
std::string inLines(std::string text, const std::string& indent = "") {
  std::string out;
  while (text.size() > kColumns) {
    std::size_t cut = text.rfind(' ', kColumns);
    if (cut == std::string::npos || cut <= indent.size()) cut = kColumns;
    out += text.substr(0, cut) + "\n";
    text.erase(0, text.find_first_not_of(' ', cut)).insert(0, indent);
  }
  return out + text + "\n";
}

/// "what      words that go on below themselves"
template <class... Values>
std::string line(const char* format, Values... values) {
  return inLines(text::formatted(format, values...), std::string(10, ' '));
}

/// What would decide between the first effects of `ambiguous`: of all, the page has it.
std::string experimentLines(const Identification& identification) {
  if (identification.verdict != Verdict::kAmbiguous) return "";
  std::string text;
  std::size_t shown = 0;
  for (const twin::EffectInfo* const effect : undecidedEffects(identification))
    if (shown++ < kExperimentsShown)
      text += line("%-9s %s: %s", text.empty() ? "decides" : "", std::string{effect->id}.c_str(),
                   std::string{effect->separated_by}.c_str());
  return text;
}

std::string whereText(const Localization& where) {
  std::string text;
  const std::string block = where.blocks.first ? "; loop: the " + std::string{name(*where.blocks.first)} : "";
  if (!where.places.empty()) {
    const GapInterval& place = where.places.front();
    text = line("where     %s, %.1f to %.1f s (%s), %.3g %s%s", place.file.c_str(), place.t0_s, place.t1_s,
                place.happens.c_str(), place.size, place.unit.c_str(), block.c_str());
  } else if (!block.empty()) {
    text = line("where     %s", block.substr(2).c_str());
  }
  return text;
}

std::string whatText(const Identification& identification) {
  std::string text;
  std::size_t all = 0;
  for (const IdentifiedEffect& found : identification.effects) all += found.estimates.size();
  std::size_t left = all > kEstimatesShown ? kEstimatesShown - 1 : kEstimatesShown;
  for (const IdentifiedEffect& found : identification.effects)
    for (const Estimate& estimate : found.estimates) {
      if (left == 0) return text + "          and more: see the report\n";
      --left;
      const std::string known = estimate.seen ? "90 %: " + interval(estimate.low, estimate.high, estimate.unit)
                                              : std::string{messages::kNotIdentifiable};
      text += line("%-9s %s = %s   (%s), gain %.0f",
                   text.empty() ? (identification.verdict == Verdict::kUnknown ? "helps" : "what") : "",
                   estimate.name.c_str(), withUnit(estimate.value, estimate.unit).c_str(), known.c_str(), found.gain);
    }
  return text;
}

/// "coulomb + backlash instead", or "backlash as well" of one that has all that was found.
std::string asAlternative(const Rival& rival, const Identification& identification) {
  const std::vector<std::string> more = addedBy(rival, identification);
  return more.empty() ? text::joined(rival.effects, " + ") + " instead" : text::joined(more, " + ") + " as well";
}

std::string rivalText(const Identification& identification) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kRivalsShown, identification.rivals.size()); ++i) {
    const Rival& rival = identification.rivals[i];
    const std::string behind =
        identification.isSelectedByPrediction()
            ? predictionOf(rival, identification)
            : text::formatted("worse by %.0f%s", rival.behind, rival.isClose() ? ", not excluded" : "");
    text += line("%-9s %s: %s", i == 0 ? "rivals" : "", asAlternative(rival, identification).c_str(), behind.c_str());
  }
  const std::size_t conflicts = identification.verdict == Verdict::kAmbiguous ? 1 : kConflictsShown;
  for (std::size_t i = 0; i < std::min(conflicts, identification.prior_conflicts.size()); ++i) {
    const PriorConflict& one = identification.prior_conflicts[i];
    text += line("%-9s %s has to be %.3f times what was given: %.1f sigma", i == 0 ? "conflict" : "",
                 one.number.c_str(), one.factor, std::abs(one.sigmas));
  }
  const std::size_t rejected = identification.prior_conflicts.empty() ? kRejectedShown : 0;
  for (std::size_t i = 0; i < std::min(rejected, identification.rejected.size()); ++i)
    text += line("%-9s %s", i == 0 ? "not named" : "", shortRejection(identification.rejected[i]).c_str());
  return text;
}

/// Numbers of the servo that the fit moved by a percent or more; back EMF follows the torque constant.
std::string numbersText(const Outcome& outcome) {
  std::string text;
  for (const MovedNumber& one : movedNumbers(outcome.baseline.servo, outcome.identification.model.servo))
    if (one.key != "back_emf" && std::abs(one.after - one.before) >= 0.01 * std::abs(one.before))
      text += (text.empty() ? "" : ", ") + one.key + " = " + withUnit(one.after, one.unit) +
              " (given: " + text::formatted("%.4g", one.before) + ")";
  return text.empty() ? "" : line("numbers   %s", text.c_str());
}

std::string rowText(const std::string& what, const Gap& gap, bool below_floor) {
  return text::formatted(
      "  %-30s %10s %10s %10s %12s%s\n", what.c_str(), inMrad(gap.before_rad).c_str(), inMrad(gap.after_rad).c_str(),
      inMrad(gap.floor_rad).c_str(),
      std::isfinite(gap.floorsAfter()) ? (std::to_string(gap.floorsAfter()).substr(0, 5) + " floors").c_str() : "-",
      below_floor ? ("  a log " + std::string{messages::kBelowFloorFlag} + "!").c_str() : "");
}

/// One log in which the arm falls to the other side may be most of an rms error.
std::string otherLogsText(const Comparison& comparison) {
  if (comparison.other_logs < 3) return "";
  return inLines("    half of these: within " + inMrad(comparison.median_other_rad) +
                     "; worst: " + inMrad(comparison.worst_other_rad) + " in " + comparison.worst_other,
                 std::string(4, ' '));
}

std::string tableText(const Comparison& comparison) {
  return line("%-32s %10s %10s %10s %12s", "position error, rms, mrad", "before", "after", "noise", "after in") +
         rowText(std::string{messages::kHeldOutLogs} + " (" + std::to_string(comparison.held_out_logs) + ")",
                 comparison.held_out, comparison.anyBelowFloor()) +
         rowText("logs of the fit (" + std::to_string(comparison.fit_logs) + ")", comparison.fit, false) +
         (comparison.other_logs == 0
              ? ""
              : rowText(std::string{messages::kOtherLogs} + " (" + std::to_string(comparison.other_logs) + ")",
                        comparison.others, false) +
                    otherLogsText(comparison));
}

}  // namespace

std::string asText(const Case& given, const Comparison& comparison) {
  return "case " + given.name + ": two models compared\n" + inLines(helpSentence(comparison)) + "\n" +
         tableText(comparison);
}

std::string asText(const Case& given, const Outcome& outcome, const Comparison& comparison) {
  const Identification& identification = outcome.identification;
  std::string text = "case " + given.name + ": " + std::string{nameOf(identification.verdict)} + "\n";
  for (const std::string& sentence : verdictSentences(outcome, comparison)) text += inLines(sentence);
  if (!outcome.remainder.empty()) text += inLines(outcome.remainder);
  for (const std::string& sentence :
       {intervalSentence(identification), triedSentence(identification), writeTimeSentence(given, identification)})
    if (!sentence.empty()) text += inLines(sentence);
  for (const Contradiction& found : contradictionsOf(given)) text += inLines(asSentence(found));
  text += "\n" + whereText(outcome.localization) + whatText(identification) + numbersText(outcome) +
          rivalText(identification) + experimentLines(identification);
  text += "\n" + tableText(comparison);
  text += "\n";
  if (const double repeats_rad = outcome.localization.floor.repeats_rad; repeats_rad >= 0)
    text += "repeats differ by " + inMrad(repeats_rad) + " mrad; ";
  std::string chance;
  if (std::isfinite(identification.threshold))
    chance = "chance gain " + std::to_string(std::lround(identification.threshold)) + " (" +
             chanceShare(identification) + "); ";
  return text + line("%smisfit %.1f sigma (a gap: %.0f); %.0f s", chance.c_str(), identification.misfit,
                     thresholds::kMisfitSigmas, outcome.runtime_s);
}

std::string asText(const Case& given, const Outcome& outcome) {
  return asText(given, outcome, compare(given, outcome.baseline, outcome.identification.model));
}

}  // namespace darwinop::gap
