// The ranking for people and for programs.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text/formatted.hpp"
#include "core/text/number_text.hpp"
#include "gap/plan/ranking.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kMostLines = 8;

std::string inSigma(double sigma) {
  if (sigma >= thresholds::kMostPrintedSigmas)
    return "more than " + text::fixedText(thresholds::kMostPrintedSigmas, 0) + " sigma";
  return text::fixedText(sigma, sigma < 10 ? 1 : 0) + " sigma";
}

std::string within(double seconds) {
  return " in " + text::fixedText(seconds, 0) + " s";
}

/// "0.079 to 0.083 N m", nine in ten.
std::string intervalOf(const FittedHypothesis& hypothesis, std::size_t i, double sigma) {
  const Unknown& unknown = hypothesis.unknowns[i];
  const double x = hypothesis.x[static_cast<Eigen::Index>(i)];
  const double low = std::max(unknown.low, unknown.fromSearch(x - thresholds::kInterval90 * sigma));
  const double high = std::min(unknown.high, unknown.fromSearch(x + thresholds::kInterval90 * sigma));
  std::string text = text::generalText(low, 4) + " to " + text::generalText(high, 4);
  const auto* const parameter = std::get_if<EffectParameter>(&unknown.what);
  if (parameter != nullptr && !parameter->row().unit.empty()) text += " " + std::string{parameter->row().unit};
  return text;
}

std::string separationsText(const Question& question, const Ranked& ranked) {
  std::string text = "separates ";
  for (const Separation& one : ranked.separations)
    text += (&one == ranked.separations.data() ? "" : ", ") + question.hypotheses[one.a].name + " from " +
            question.hypotheses[one.b].name + " by " + inSigma(one.sigma);
  return text;
}

std::string revealsText(const Question& question, std::vector<Separation> separations) {
  std::ranges::stable_sort(separations, std::greater{}, &Separation::sigma);
  std::string text;
  for (const Separation& one : separations)
    if (one.sigma >= thresholds::kListedAsShown)
      text += (text.empty() ? "would show " : ", ") + question.hypotheses[one.b].name + " by " + inSigma(one.sigma);
  return text.empty() ? "would show none of them" : text;
}

std::string headOf(const Question& question) {
  const FittedHypothesis& first = question.hypotheses.front();
  switch (question.aim) {
    case Aim::kSeparate:
      return "Which experiment distinguishes these explanations?\n";
    case Aim::kReveal:
      return "These logs cannot show some effects. Which experiment would, at their usual size?\n";
    case Aim::kNarrow:
      break;
  }
  return "Which experiment narrows the interval of " + first.unknowns[question.unknown].name + "?\n";
}

/// Those of its name, which lists them.
std::vector<const twin::EffectInfo*> effectsIn(const FittedHypothesis& hypothesis) {
  std::vector<const twin::EffectInfo*> effects;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    if ((" + " + hypothesis.name + " + ").find(" + " + std::string{effect->id} + " + ") != std::string::npos)
      effects.push_back(effect);
  return effects;
}

/// Parameters of the hypothesis, and the catalogue's advice for each of its effects.
std::string hypothesisText(const FittedHypothesis& hypothesis) {
  std::string text = "  " + hypothesis.name;
  const Eigen::VectorXd sigmas = hypothesis.sigmas();
  bool first = true;
  for (std::size_t i = 0; i < hypothesis.unknowns.size(); ++i) {
    if (std::isfinite(hypothesis.unknowns[i].sigma)) continue;  // of the baseline
    text += (first ? ": " : ", ") + hypothesis.unknowns[i].name + " " +
            intervalOf(hypothesis, i, sigmas[static_cast<Eigen::Index>(i)]);
    first = false;
  }
  text += "\n";
  for (const twin::EffectInfo* const effect : effectsIn(hypothesis))
    text += "    catalogue: " + std::string{effect->separated_by} + "\n";
  return text;
}

/// "  coulomb or com_mass: hold_from_both_sides, 20 s of robot time, 12 sigma"
std::string decisionsText(const NextExperiments& next) {
  std::string text;
  for (const Decision& one : decisionsOf(next))
    text += "  " + next.question.hypotheses[one.pair.a].name + " or " + next.question.hypotheses[one.pair.b].name +
            ": " + one.by->vetted.candidate.experiment.name + ", " + text::fixedText(one.by->vetted.seconds, 0) +
            " s of robot time, " + inSigma(one.pair.sigma) + "\n";
  return text.empty() ? "" : "For each pair\n" + text;
}

bool isUninformative(const Question& question, const Ranked& ranked) {
  return question.aim != Aim::kNarrow && std::ranges::all_of(ranked.separations, [](const Separation& one) {
           return one.sigma < thresholds::kUninformative;
         });
}

}  // namespace

std::vector<Decision> decisionsOf(const NextExperiments& next) {
  std::vector<Decision> decisions;
  if (next.question.aim != Aim::kSeparate || next.ranked.empty()) return decisions;
  for (std::size_t pair = 0; pair < next.ranked.front().separations.size(); ++pair) {
    Decision best;
    for (const Ranked& ranked : next.ranked) {
      const Separation& there = ranked.separations[pair];
      if (there.sigma > best.pair.sigma && best.pair.sigma < thresholds::kListedAsShown) best = {&ranked, there};
    }
    if (best.by != nullptr && best.pair.sigma >= thresholds::kUninformative) decisions.push_back(best);
  }
  return decisions;
}

std::string sentenceOf(const Question& question, const Ranked& ranked) {
  std::string text = ranked.vetted.candidate.experiment.name + ": ";
  if (question.aim == Aim::kSeparate) text += separationsText(question, ranked);
  if (question.aim == Aim::kReveal) text += revealsText(question, ranked.separations);
  if (question.aim == Aim::kNarrow) {
    const FittedHypothesis& first = question.hypotheses.front();
    text += "narrows " + first.unknowns[question.unknown].name + " from " +
            intervalOf(first, question.unknown, ranked.sigma_before) + ", nine in ten, to " +
            intervalOf(first, question.unknown, ranked.sigma_after);
  }
  return text + within(ranked.vetted.seconds);
}

std::string asText(const NextExperiments& next) {
  std::string text = headOf(next.question);
  for (const FittedHypothesis& hypothesis : next.question.hypotheses) text += hypothesisText(hypothesis);
  text += decisionsText(next);
  text += "Experiments of " + std::string{row(next.stand.joint).name} + ", most per minute first\n";
  std::string nothing;
  std::size_t line = 0;
  for (const Ranked& ranked : next.ranked) {
    const experiments::Experiment& experiment = ranked.vetted.candidate.experiment;
    if (isUninformative(next.question, ranked)) nothing += (nothing.empty() ? "" : ", ") + experiment.name;
    if (isUninformative(next.question, ranked) || ++line > kMostLines) continue;
    text += text::formatted("%3zu. ", line) + sentenceOf(next.question, ranked) + "\n     " + experiment.title;
    if (!ranked.vetted.candidate.prepare.empty()) text += "; " + ranked.vetted.candidate.prepare;
    text += "\n";
    for (const std::string& cut : ranked.vetted.cuts) text += "     shortened: " + cut + "\n";
  }
  if (line == 0) text += "     none of them is informative\n";
  if (!nothing.empty()) text += "Less than 1 sigma: " + nothing + "\n";
  for (const Refusal& refusal : next.refused) text += "Refused: " + refusal.name + ": " + refusal.why + "\n";
  return text;
}

nlohmann::json asJson(const NextExperiments& next) {
  using nlohmann::json;
  constexpr const char* kAims[]{"separate", "reveal", "narrow"};
  json out{{"aim", kAims[static_cast<std::size_t>(next.question.aim)]},
           {"joint", std::string{row(next.stand.joint).name}},
           {"hypotheses", json::array()},
           {"experiments", json::array()},
           {"refused", json::array()}};
  for (const FittedHypothesis& hypothesis : next.question.hypotheses) {
    json numbers = json::object();
    for (std::size_t i = 0; i < hypothesis.unknowns.size(); ++i)
      numbers[hypothesis.unknowns[i].name] =
          hypothesis.unknowns[i].fromSearch(hypothesis.x[static_cast<Eigen::Index>(i)]);
    json catalogue = json::object();
    for (const twin::EffectInfo* const effect : effectsIn(hypothesis))
      catalogue[std::string{effect->id}] = std::string{effect->separated_by};
    out["hypotheses"].push_back({{"name", hypothesis.name}, {"numbers", numbers}, {"separated_by", catalogue}});
  }
  for (const Decision& one : decisionsOf(next))
    out["decisions"].push_back(
        {{"between", {next.question.hypotheses[one.pair.a].name, next.question.hypotheses[one.pair.b].name}},
         {"experiment", one.by->vetted.candidate.experiment.name},
         {"seconds", one.by->vetted.seconds},
         {"sigma", one.pair.sigma}});
  if (next.question.aim == Aim::kNarrow)
    out["number"] = next.question.hypotheses.front().unknowns[next.question.unknown].name;
  for (const Ranked& ranked : next.ranked) {
    const ExperimentCandidate& candidate = ranked.vetted.candidate;
    json one{{"name", candidate.experiment.name},     {"title", candidate.experiment.title},
             {"seconds", ranked.vetted.seconds},      {"gain", ranked.gain},
             {"gain_per_minute", ranked.perMinute()}, {"payload_kg", candidate.payload_kg},
             {"prepare", candidate.prepare},          {"shortened", ranked.vetted.cuts}};
    one["separations"] = json::array();
    for (const Separation& pair : ranked.separations)
      one["separations"].push_back({{"of", next.question.hypotheses[pair.a].name},
                                    {"from", next.question.hypotheses[pair.b].name},
                                    {"sigma", pair.sigma}});
    out["experiments"].push_back(std::move(one));
  }
  for (const Refusal& refusal : next.refused) out["refused"].push_back({{"name", refusal.name}, {"why", refusal.why}});
  return out;
}

}  // namespace darwinop::gap
