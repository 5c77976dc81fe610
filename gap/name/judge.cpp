#include "gap/name/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/data/plausible.hpp"
#include "gap/sim/freed.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNineInTen = 1.645;  // sigma on either side
constexpr double kFits = 1.15;        // cost over what noise makes of it: as a right model has it
constexpr double kTogether = 8;       // samples of 16 ms that are off together where a model is wrong
constexpr double kRemains = 3;        // floors that may remain when most of a large gap is gone
constexpr double kMost = 0.85;        // of the gap
constexpr double kSharpest =
    0.004;  // of a number: a limit of 80 rad/s2 came back 0.3 % off from another simulator's logs
constexpr double kAtBound = 1e-3;  // of the range
constexpr double kNothing = 3e-4;  // of the range: an encoder's step shows no delay, play or gain as small as that
constexpr double kLeast = 2;       // floors: a smaller gap without a name tells too little

double sigmasOff(const Settled& fitted, std::size_t i) {
  const Unknown& unknown = fitted.problem.unknowns()[i];
  if (!std::isfinite(unknown.sigma)) return 0;
  return (unknown.fromSearch(fitted.fit.x[static_cast<Eigen::Index>(i)]) - unknown.expected) / unknown.sigma;
}

}  // namespace

double misfitOf(const Settled& fitted, const Replicas& replicas) {
  return (fitted.fit.cost - fitted.fit.prior - replicas.cost_mean) / replicas.cost_sigma;
}

double mostStrained(const Settled& fitted) {
  double most = 0;
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i)
    most = std::max(most, std::abs(sigmasOff(fitted, i)));
  return most;
}

double leastGain(const Case& given, const Hypothesis& found, const twin::EffectInfo& effect, double threshold) {
  const bool strained = freesAPrior(given, effect) && sigmasOfFreed(given, found, effect) > kSuspicious;
  return strained ? kStrainGain : threshold;
}

std::vector<Strained> strainedOf(const Settled& fitted) {
  std::vector<Strained> strained;
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i) {
    const Unknown& unknown = fitted.problem.unknowns()[i];
    const double sigmas = sigmasOff(fitted, i);
    if (std::abs(sigmas) > kStrained)
      strained.push_back(
          {unknown.name, sigmas, unknown.fromSearch(fitted.fit.x[static_cast<Eigen::Index>(i)]) / unknown.expected});
  }
  return strained;
}

std::vector<Estimate> estimatesOf(const Settled& fitted, const twin::EffectInfo& effect, double excess) {
  // What a model leaves unexplained is no white noise: neighbouring samples are off together.
  const double wider = excess > kFits ? std::sqrt(kTogether * excess) : 1;
  std::vector<Estimate> estimates;
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || parameter->info != &effect) continue;
    const auto at = static_cast<Eigen::Index>(i);
    if (!std::isfinite(fitted.fit.covariance(at, at))) {
      estimates.push_back({unknowns[i].name, std::string{effect.parameters[parameter->index].unit},
                           effect.parameters[parameter->index].neutral, unknowns[i].low, unknowns[i].high, false});
      continue;
    }
    const double x = fitted.fit.x[at], value = unknowns[i].fromSearch(x);
    const double sharpest = kSharpest * (unknowns[i].logarithmic ? 1 : std::abs(value));
    const double half = std::max(sharpest, wider * kNineInTen * std::sqrt(fitted.fit.covariance(at, at)));
    if (unknowns[i].name == "transport_delay.delay") {
      // A goal acts from the first period after it has come: which instant within the one before, nobody can tell.
      const double early = fitted.problem.hypothesis().servo.firmware_period_s / 2;
      const double later = std::max(early, unknowns[i].fromSearch(x + half) - value);
      estimates.push_back({unknowns[i].name, "s", value - early, std::max(0.0, value - early - later),
                           std::min(unknowns[i].high, value - early + later)});
      continue;
    }
    estimates.push_back({unknowns[i].name, std::string{effect.parameters[parameter->index].unit}, value,
                         std::max(unknowns[i].low, unknowns[i].fromSearch(x - half)),
                         std::min(unknowns[i].high, unknowns[i].fromSearch(x + half))});
  }
  return estimates;
}

Hypothesis withoutUnseen(const Settled& fitted) {
  Hypothesis found = fitted.hypothesis();
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&fitted.problem.unknowns()[i].what);
    const auto at = static_cast<Eigen::Index>(i);
    if (parameter == nullptr || std::isfinite(fitted.fit.covariance(at, at))) continue;
    Hypothesis neutral = found;
    neutral.with(*parameter->info).values[parameter->index] = parameter->info->parameters[parameter->index].neutral;
    const Problem as_found{*fitted.evidence, found, {}}, as_neutral{*fitted.evidence, neutral, {}};
    if (as_neutral.cost({}) < as_found.cost({}) + 1) found = std::move(neutral);
  }
  return found;
}

std::vector<std::string> idsOf(const Effects& effects) {
  std::vector<std::string> ids;
  for (const Chosen& effect : effects) ids.emplace_back(effect.info->id);
  return ids;
}

bool isAtItsBound(const Settled& fitted, const twin::EffectInfo& effect) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || parameter->info != &effect || std::isfinite(unknowns[i].sigma)) continue;
    const double low = unknowns[i].toSearch(unknowns[i].low), high = unknowns[i].toSearch(unknowns[i].high);
    const double neutral = unknowns[i].toSearch(effect.parameters[parameter->index].neutral);
    const double x = fitted.fit.x[static_cast<Eigen::Index>(i)], near = kAtBound * (high - low);
    if ((x < low + near && neutral > low + near) || (x > high - near && neutral < high - near)) return true;
  }
  return false;
}

bool isNextToNothing(const Settled& fitted, const twin::EffectInfo& effect) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const own = std::get_if<EffectParameter>(&unknowns[i].what);
    if (own == nullptr || own->info != &effect) continue;
    const twin::Parameter& parameter = effect.parameters[own->index];
    const double value = unknowns[i].fromSearch(fitted.fit.x[static_cast<Eigen::Index>(i)]);
    if (!parameter.secondary && std::abs(value - parameter.neutral) > kNothing * (parameter.high - parameter.low))
      return false;
  }
  return !unknownsOf(effect).empty();
}

double gapOf(const Case& given, const Hypothesis& hypothesis, bool score) {
  double sum = 0, count = 0;
  Trace trace;
  const auto copies = duplicates(given);
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    const Trajectory& log = given.logs[i];
    if (log.score != score || copies[i]) continue;
    rollOut(given, i, hypothesis, {}, trace);
    for (std::size_t row = 0; row < log.rows(); ++row) {
      const double off = log.position_rad[row] - trace.position_rad[row];
      sum += off * off, ++count;
    }
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(sum / count);
}

double meanErrorOf(const Case& given, const Hypothesis& hypothesis, bool score) {
  double sum = 0, count = 0;
  Trace trace;
  const auto copies = duplicates(given);
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    const Trajectory& log = given.logs[i];
    if (log.score != score || copies[i]) continue;
    rollOut(given, i, hypothesis, {}, trace);
    for (std::size_t row = 0; row < log.rows(); ++row)
      sum += std::abs(log.position_rad[row] - trace.position_rad[row]) / static_cast<double>(log.rows());
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / count;
}

double floorOf(const Settled& fitted) {
  double sum = 0, count = 0;
  for (const LogNoise& noise : fitted.evidence->noise) {
    const Eigen::VectorXd sigma = noise.positionSigma();
    sum += sigma.squaredNorm(), count += static_cast<double>(sigma.size());
  }
  return std::sqrt(sum / count);
}

Verdict verdictOf(const Naming& naming) {
  const bool explained = naming.misfit < kMisfit || (naming.gap_after_rad < kRemains * naming.floor_rad &&
                                                     naming.gap_after_rad < (1 - kMost) * naming.gap_before_rad);
  if (naming.found.empty()) {
    if (naming.misfit < kMisfit) return naming.strained.empty() ? Verdict::kNone : Verdict::kCannotTell;
    return naming.gap_after_rad < kLeast * naming.floor_rad ? Verdict::kCannotTell : Verdict::kUnknown;
  }
  if (!explained) return Verdict::kUnknown;
  const bool close =
      std::any_of(naming.rivals.begin(), naming.rivals.end(), [](const Rival& rival) { return rival.isClose(); });
  return close ? Verdict::kAmbiguous : Verdict::kNamed;
}

}  // namespace darwinop::gap
