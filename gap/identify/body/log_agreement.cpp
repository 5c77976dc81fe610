#include "gap/identify/body/log_agreement.hpp"

#include <algorithm>
#include <map>

#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

LogGain& LogGain::operator+=(const LogGain& other) {
  gain += other.gain, change += other.change, expected += other.expected;
  cost += other.cost, samples += other.samples;
  return *this;
}

LogGain& LogGain::operator/=(double rows_alike) {
  gain /= rows_alike, change /= rows_alike, expected /= rows_alike;
  cost /= rows_alike, samples /= rows_alike;
  return *this;
}

double LogGain::remainder() const {
  return samples > 0 ? std::max(1.0, (cost + std::min(0.0, gain)) / samples) : 1;
}

bool LogGain::decides() const {
  return change > thresholds::kDecidingChange * remainder();
}

bool refutes(const LogGain& log) {
  return log.decides() && log.gain < -log.change / 2;
}

bool supports(const LogGain& log) {
  return log.decides() && log.gain > log.expected / 2;
}

LogGain gainOf(const Eigen::VectorXd& without, const Eigen::VectorXd& with) {
  const double cost = robustCost(with);
  return {.gain = robustCost(without) - cost,
          .change = (with - without).squaredNorm(),
          .expected = (with - without).cwiseAbs2().dot(robustWeights(with.cwiseAbs().cwiseMax(without.cwiseAbs()))),
          .cost = cost,
          .samples = static_cast<double>(with.size())};
}

namespace {

/// By log.
std::map<std::size_t, LogGain> gainsIn(const LimbResiduals& residuals, const BodyHypothesis& without,
                                       const BodyHypothesis& with) {
  const Eigen::VectorXd before = residuals.of(without), after = residuals.of(with);
  std::map<std::size_t, LogGain> logs;
  for (const LimbSamples& block : residuals.blocks()) {
    LogGain gain = gainOf(before.segment(block.begin, block.rows), after.segment(block.begin, block.rows));
    if (block.is_load) gain.samples = 0;  // their cost is near zero: they would hide a misfit of the positions
    logs[block.log] += gain;
  }
  return logs;
}

LogGain sumOf(const std::map<std::size_t, LogGain>& logs) {
  LogGain all;
  for (const auto& [log, gain] : logs) all += gain;
  return all;
}

}  // namespace

LogGain gainOf(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without, const BodyHypothesis& with) {
  return sumOf(gainsIn(robot.residuals(limb), without, with));
}

LogGain heldOutGain(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without,
                    const BodyHypothesis& with) {
  const std::vector<std::size_t> logs = clampedLogs(robot.given(), true);
  if (logs.empty()) return {};
  const LimbResiduals& fitted = robot.residuals(limb);
  const LimbResiduals held_out{robot.given(), logs, robot.limbs()[limb], fitted.withNumbers(with)};
  return sumOf(gainsIn(held_out, fitted.withNumbers(without), fitted.withNumbers(with)));
}

bool anyLogRefutes(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& without,
                   const BodyHypothesis& with) {
  std::map<std::size_t, LogGain> logs;
  for (const std::size_t limb : limbs)
    for (const auto& [log, gain] : gainsIn(robot.residuals(limb), without, with)) logs[log] += gain;
  return std::ranges::any_of(logs, [](const auto& one) { return refutes(one.second); });
}

}  // namespace darwinop::gap
