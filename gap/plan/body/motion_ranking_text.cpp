// A plan for the whole robot, for people and for programs.
#include <algorithm>
#include <cmath>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "gap/plan/body/motion_ranking.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/thresholds.hpp"

namespace darwinop::gap {
namespace {

using BodyObject = nlohmann::ordered_json;

constexpr std::size_t kListedMotions = 6;

std::vector<std::string> namesIn(const BodyQuestion& question, std::size_t from) {
  std::vector<std::string> names;
  for (std::size_t i = from; i < question.models.size(); ++i) names.push_back(question.models[i].name);
  return names;
}

/// "link_com Body from floor_tilt floor"; in the order of RankedMotion::differences.
std::vector<std::string> pairsOf(const BodyQuestion& question) {
  std::vector<std::string> pairs;
  for (std::size_t a = 0; a < (question.is_rivalry ? question.models.size() : 1); ++a)
    for (std::size_t b = a + 1; b < question.models.size(); ++b)
      pairs.push_back(question.is_rivalry ? question.models[a].name + " from " + question.models[b].name
                                          : question.models[b].name);
  return pairs;
}

std::string sigmasText(double sigma) {
  return sigma > thresholds::kMostPrintedSigmas
             ? text::formatted("more than %.0f sigma", thresholds::kMostPrintedSigmas)
             : text::formatted("%.1f sigma", sigma);
}

bool isShown(const SignalDifference& difference) {
  return difference.sigma >= thresholds::kListedAsShown;
}

/// Records it, and adds it to the case; clamped only.
std::string recordCommand(const PlannedMotion& motion, const std::string& folder) {
  std::vector<std::string> up;
  for (const double part : *motion.up) up.push_back(text::shortestText(part));
  return "darwinop gap record --add " + motion.experiment + " --up " + text::joined(up, ",") + " --out " + folder;
}

/// Of a motion on the floor, which `darwinop gap record` does not record.
BodyObject floorEntry(const PlannedMotion& motion) {
  BodyObject entry{{"file", motion.experiment + ".csv"}, {"role", "fit"}, {"setup", name(motion.setup)}};
  if (!motion.lies_on.empty()) entry["up"] = motion.lies_on;
  return entry;
}

std::string textOf(const RankedMotion& ranked, const std::vector<std::string>& pairs, const std::string& folder) {
  std::string text = ranked.motion.name() + text::formatted(": %.1f min; first ", ranked.motion.seconds / 60) +
                     ranked.motion.prepare + "\n";
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SignalDifference& difference = ranked.differences[i];
    if (isShown(difference))
      text += "     " + pairs[i] + ": " + sigmasText(difference.sigma) + ", most in " + difference.largest +
              text::formatted(" (%.2g noise floors)\n", difference.floors);
  }
  return text + "     " +
         (ranked.motion.up ? recordCommand(ranked.motion, folder)
                           : messages::kFloorMotion + floorEntry(ranked.motion).dump()) +
         "\n";
}

}  // namespace

std::string asText(const BodyPlan& plan, const std::string& folder) {
  const BodyQuestion& question = plan.question;
  if (question.models.size() < 2) return "The recordings of this case show every effect that is planned for.\n";
  const std::vector<std::string> pairs = pairsOf(question);
  std::string motions;
  std::size_t listed = 0;
  for (const RankedMotion& ranked : plan.ranked)
    if (listed < kListedMotions && std::ranges::any_of(ranked.differences, isShown))
      motions += text::formatted("%3zu  ", ++listed) + textOf(ranked, pairs, folder);
  std::string text, aim = "separate " + text::joined(namesIn(question, 0));
  if (!question.is_rivalry)
    text = "Effects that these recordings cannot show: " + text::joined(namesIn(question, 1)) + ".\n",
    aim = "show them";
  if (listed > 0) text += "Recordings that " + aim + ", with the --robot of the others:\n" + motions;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (std::ranges::none_of(plan.ranked, [&](const RankedMotion& one) { return isShown(one.differences[i]); }))
      text += "No motion known here: " + pairs[i] + "\n";
  if (!plan.left_out.empty()) text += messages::kFloorNotPlanned + text::joined(plan.left_out, "; ") + "\n";
  return text;
}

nlohmann::ordered_json asJson(const BodyPlan& plan, const std::string& folder) {
  BodyObject motions = BodyObject::array();
  const std::vector<std::string> pairs = pairsOf(plan.question);
  for (const RankedMotion& ranked : plan.ranked) {
    BodyObject shows = BodyObject::array();
    for (std::size_t i = 0; i < pairs.size(); ++i)
      shows.push_back({{"what", pairs[i]},
                       {"sigma", ranked.differences[i].sigma},
                       {"signal", ranked.differences[i].largest},
                       {"floors", ranked.differences[i].floors}});
    motions.push_back({{"experiment", ranked.motion.experiment},
                       {"where", ranked.motion.where},
                       {"first", ranked.motion.prepare},
                       {"seconds", ranked.motion.seconds},
                       {"gain_per_minute", ranked.perMinute()},
                       {"shows", shows}});
    if (ranked.motion.up)
      motions.back()["run"] = recordCommand(ranked.motion, folder);
    else
      motions.back()["entry"] = floorEntry(ranked.motion);
  }
  return {{"aim", plan.question.is_rivalry ? "separate" : "reveal"},
          {"models", namesIn(plan.question, 0)},
          {"experiments", motions},
          {"left_out", plan.left_out}};
}

}  // namespace darwinop::gap
