#include "gap/localize/block_finder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

std::string oneDigit(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.1f", value))};
}

}  // namespace

BlockFinder::BlockFinder(const Plant& plant, const Case& given, const Hypothesis& baseline,
                         const std::vector<std::size_t>& logs, const SimulatedRepeats& copies)
    : plant_{plant},
      given_{given},
      logs_{logs},
      copies_{copies},
      baseline_{baseline},
      numbers_{nuisancesOf(given, baseline)} {
  for (std::size_t i = 0; i < kBlocks; ++i) {
    out_.all[i].block = static_cast<Block>(i);
    out_.all[i].rms = out_.all[i].expected_rms = kNotKnown;
  }
}

Blocks BlockFinder::find() {
  supply();
  sensor();
  if (baseline_.servo.law == twin::Law::kSpeedP)
    lawAndMotorAtOnce();
  else if (std::ranges::any_of(logs_, [&](std::size_t i) { return loadIsDutyIn(baseline_, given_.logs[i]); }))
    lawByItsDuty();
  else
    noDuty();
  for (const Block block : plant_.blocks())
    if (!out_.first && out_.of(block).verdict == BlockVerdict::kOpen) out_.first = block;
  return std::move(out_);
}

BlockResiduals BlockFinder::residuals(Block block, const Trajectory& log, const Hypothesis& hypothesis,
                                      const ShootingOptions& options) const {
  return plant_.blockResiduals(block, plant_.places().front(), given_, log, hypothesis, options);
}

BlockTest BlockFinder::judged(const BlockResidualFunction& cut, bool priors) const {
  return judge(cut, given_, logs_, copies_, baseline_, priors ? numbers_ : std::vector<Unknown>{});
}

BlockTest BlockFinder::judgedWith(const BlockResidualFunction& cut, const Hypothesis& hypothesis) const {
  return judge(cut, given_, logs_, simulateRepeats(plant_, given_, logs_, hypothesis), hypothesis,
               nuisancesOf(given_, hypothesis));
}

void BlockFinder::take(Block block, BlockTest judgement, const std::string& unit, double per_unit) {
  BlockFinding& into = out_.of(block);
  into.unit = unit;
  into.rms = judgement.rms / per_unit;
  into.expected_rms = judgement.expected_rms / per_unit;
  into.significance = judgement.significance;
  into.moved = judgement.moved;
  into.verdict = judgement.isOpen() ? BlockVerdict::kOpen : BlockVerdict::kClosed;
  if (judgement.significance <= thresholds::kOpenSigmas && judgement.moved > thresholds::kMovedSigmas)
    into.detail = "closes only with numbers far outside their priors, " + oneDigit(judgement.moved) + " sigma";
  into.samples = std::move(judgement.samples);
}

void BlockFinder::supply() {
  out_.supply_ohm = out_.supply_ohm_sigma = kNotKnown;
  const BlockTest cut = judged([&](const auto& log, const auto& h) { return residuals(Block::kSupply, log, h); });
  if (!cut.known()) return notCut(Block::kSupply, "the logs have no voltage");
  BlockFinding& into = out_.of(Block::kSupply);
  take(Block::kSupply, cut, "V", 1);
  if (baseline_.servo.law == twin::Law::kSpeedP) return;  // the current of its motor is unknown
  std::vector<const Trajectory*> measured;
  measured.reserve(logs_.size());
  for (const std::size_t i : logs_) measured.push_back(&given_.logs[i]);
  const double slope = plant_.supplyResistance(plant_.places().front(), given_, measured, baseline_);
  double spread = 0;
  for (const auto& run : copies_) {
    std::vector<const Trajectory*> copied;
    copied.reserve(run.size());
    for (const Trajectory& log : run) copied.push_back(&log);
    spread += std::pow(plant_.supplyResistance(plant_.places().front(), given_, copied, baseline_), 2) /
              static_cast<double>(copies_.size());
  }
  // The current is computed with numbers of the motor, which are no better known than their priors.
  double by_priors = 0;
  for (const Unknown& number : numbers_) {
    const double moved = number.toSearch(number.expected + number.sigma);
    const Hypothesis other = applied(baseline_, {number}, &moved);
    by_priors += std::pow(plant_.supplyResistance(plant_.places().front(), given_, measured, other) - slope, 2);
  }
  out_.supply_ohm = slope;
  out_.supply_ohm_sigma = std::sqrt(spread + by_priors);
  if (std::isnan(slope)) return;
  char text[80];
  std::snprintf(text, sizeof text, "%.2f +- %.2f ohm", slope, out_.supply_ohm_sigma);
  into.detail = text;
  into.significance = std::max(into.significance, std::abs(slope) / std::sqrt(spread));
  if (into.significance > thresholds::kOpenSigmas) into.verdict = BlockVerdict::kOpen;
}

void BlockFinder::sensor() {
  BlockTest cut = judged([&](const auto& log, const auto& h) { return residuals(Block::kSensor, log, h); }, false);
  if (!cut.known()) return notCut(Block::kSensor, "the logs have no speed");
  take(Block::kSensor, std::move(cut), "rad/s", 1);
  BlockFinding& into = out_.of(Block::kSensor);
  if (into.rms < thresholds::kSensorRatio * into.expected_rms) into.verdict = BlockVerdict::kClosed;
}

}  // namespace darwinop::gap
