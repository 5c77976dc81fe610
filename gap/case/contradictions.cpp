#include "gap/case/contradictions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/rest_angle.hpp"

namespace darwinop::gap {
namespace {

constexpr double kIdleLoad = 0.05;  // of full duty: the current drops no more than the register resolves
constexpr std::size_t kFewestRows = 20;
constexpr double kRegisterError = 0.05;  // of the voltage: the servo reads it by its own reference
constexpr double kSigmas = 3;
constexpr double kDutyStep = 0.02;  // of full duty: registers end at 1000 or 1023 counts
constexpr double kOften = 0.01;     // of the rows

/// The load that a hundredth of the rows exceeds; NaN without load.
double greatestLoad(const Trajectory& log) {
  std::vector<double> loads;
  for (const double load : log.load)
    if (!std::isnan(load)) loads.push_back(std::abs(load));
  if (loads.size() < kFewestRows) return std::numeric_limits<double>::quiet_NaN();
  const auto at = loads.end() - 1 - static_cast<std::ptrdiff_t>(kOften * static_cast<double>(loads.size()));
  std::nth_element(loads.begin(), at, loads.end());
  return *at;
}

struct Tally {
  double sum = 0;
  std::size_t logs = 0, of = 0;
};

/// Adds what the logs measure of one number, by the value that the model has for a log.
template <class Model, class Measured, class Differs>
void tally(const Case& c, std::string_view number, std::string_view unit, const Model& model, const Measured& measured,
           const Differs& differs, std::vector<Contradiction>& into) {
  std::map<double, Tally> tallies;
  for (const Trajectory& log : c.logs) {
    const double value = measured(log);
    if (std::isnan(value)) continue;
    Tally& one = tallies[model(log)];
    ++one.of;
    if (differs(model(log), value)) one.sum += value, ++one.logs;
  }
  for (const auto& [value, one] : tallies)
    if (one.logs > 0)
      into.push_back({.number = number,
                      .unit = unit,
                      .model = value,
                      .measured = one.sum / static_cast<double>(one.logs),
                      .logs = one.logs,
                      .of = one.of});
}

}  // namespace

double idleVoltage(const Trajectory& log) {
  std::vector<double> idle;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (!std::isnan(log.volt_v[row]) && (log.torque_on[row] == 0 || std::abs(log.load[row]) < kIdleLoad))
      idle.push_back(log.volt_v[row]);
  return idle.size() < kFewestRows ? std::numeric_limits<double>::quiet_NaN() : medianOf(idle);
}

std::vector<Contradiction> contradictionsOf(const Case& c) {
  std::vector<Contradiction> found;
  if (c.pendulum.gravity_m_s2 != 0)
    tally(
        c, kRestAngle, "rad", [](const Trajectory&) { return 0.0; }, restBeyondRelease,
        [](double, double measured) { return !std::isnan(measured); }, found);
  if (c.model.servo.law != twin::Law::kVoltageP) return found;
  const auto prior = std::ranges::find(c.priors, "supply", &Prior::number);
  const double tolerance = std::max(kRegisterError, prior == c.priors.end() ? 0 : kSigmas * prior->relative_sigma);
  tally(
      c, "supply_V", "V", [&](const Trajectory& log) { return supplyOf(c, log); }, idleVoltage,
      [&](double model, double measured) { return std::abs(measured - model) > tolerance * model; }, found);
  tally(
      c, "duty_max", "", [&](const Trajectory&) { return c.model.servo.duty_max; }, greatestLoad,
      [](double model, double measured) { return measured > model + kDutyStep; }, found);
  return found;
}

std::string asSentence(const Contradiction& found) {
  char numbers[96];
  std::snprintf(numbers, sizeof numbers, "%g%s%.*s in the model and %.3g%s%.*s in ", found.model,
                found.unit.empty() ? "" : " ", int(found.unit.size()), found.unit.data(), found.measured,
                found.unit.empty() ? "" : " ", int(found.unit.size()), found.unit.data());
  return std::string{found.number} + " is " + numbers + std::to_string(found.logs) + " of " + std::to_string(found.of) +
         " logs" + messages::kContradicted;
}

}  // namespace darwinop::gap
