// Which logs of a large folder are searched: the time of a search grows with each, and the tenth log of one bench, gain
// and motion teaches little. Names of files do not count; what was set, the motion that a log names and what its goals
// do, does.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

/// What distinguishes a log. Speed and travel of the goals in powers of two.
using Traits = std::array<double, 9>;
constexpr std::size_t kKind = 8;   // of the motion
constexpr double kKindWeight = 3;  // as much as release, speed and travel, which motions of several names share

double octave(double value) {
  return value > 0 ? std::floor(std::log2(value)) : -1e3;
}

Traits traitsOf(const Trajectory& log, std::size_t kind) {
  double fastest = 0;
  for (std::size_t row = 1; row < log.rows(); ++row)
    fastest = std::max(fastest, std::abs(log.goal_rad[row] - log.goal_rad[row - 1]) /
                                    std::max(1e-6, log.time_s[row] - log.time_s[row - 1]));
  const auto [low, high] = std::ranges::minmax(log.goal_rad);
  const bool released = std::ranges::find(log.torque_on, 0) != log.torque_on.end();
  return {log.p_register,           log.payload_kg,       log.length_m.value_or(0), log.arm_mass_kg.value_or(0),
          log.supply_v.value_or(0), released ? 1.0 : 0.0, octave(fastest),          octave(high - low),
          static_cast<double>(kind)};
}

/// Likeness to those that are chosen. Squares: one log that is nearly the same counts more than several that share a
/// trait each.
double likeness(const Traits& one, const std::vector<Traits>& chosen) {
  double sum = 0;
  for (const Traits& other : chosen) {
    double same = 0;
    for (std::size_t i = 0; i < one.size(); ++i) same += one[i] == other[i] ? (i == kKind ? kKindWeight : 1) : 0;
    sum += same * same;
  }
  return sum;
}

/// Logs that show less than others: without load where others have it, or less than half as long as most.
std::vector<bool> poorOf(const std::vector<Trajectory>& logs) {
  const auto has_load = [](const Trajectory& log) {
    return std::ranges::any_of(log.load, [](double load) { return std::isfinite(load); });
  };
  std::vector<double> durations;
  for (const Trajectory& log : logs) durations.push_back(log.duration_s());
  const double usual_s = medianOf(durations);
  const bool have_load = std::ranges::any_of(logs, has_load);
  std::vector<bool> poor;
  for (const Trajectory& log : logs) poor.push_back((have_load && !has_load(log)) || log.duration_s() < usual_s / 2);
  return poor;
}

struct Bounds {
  std::size_t most, fewest;
  double most_s;
};

/// Of the logs of a role those that are least alike, one after the other; at a tie the first of the folder. Poor ones
/// differ from all others, and come last.
std::vector<bool> chosenOf(const std::vector<Trajectory>& logs, bool held_out, const Bounds& bounds) {
  std::vector<bool> taken(logs.size());
  std::vector<std::size_t> left;
  std::vector<Traits> traits, chosen;
  std::vector<std::string> kinds;  // motions that share speed and travel differ in their frequencies
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const auto kind = std::ranges::find(kinds, logs[i].kind) - kinds.begin();
    if (kind == std::ssize(kinds)) kinds.push_back(logs[i].kind);
    traits.push_back(traitsOf(logs[i], static_cast<std::size_t>(kind)));
    if (logs[i].held_out == held_out) left.push_back(i);
  }
  const std::vector<bool> poor = poorOf(logs);
  double seconds = 0;
  while (chosen.size() < bounds.most && (chosen.size() < bounds.fewest || seconds < bounds.most_s) && !left.empty()) {
    const auto next = std::ranges::min_element(left, {}, [&](std::size_t i) {
      return std::pair{static_cast<bool>(poor[i]), likeness(traits[i], chosen)};
    });
    taken[*next] = true;
    chosen.push_back(traits[*next]);
    seconds += logs[*next].duration_s();
    left.erase(next);
  }
  return taken;
}

}  // namespace

void chooseLogs(FolderCase& in) {
  Case& given = in.given;
  const std::size_t before = given.logs.size();
  const std::vector<bool> fitted = chosenOf(given.logs, false, {kMostFitLogs, kFewestChosen, kMostFitSeconds}),
                          held_out =
                              chosenOf(given.logs, true, {kMostHeldOutLogs, kFewestHeldOut, kMostHeldOutSeconds});
  std::vector<Trajectory> logs;
  for (std::size_t i = 0; i < before; ++i)
    (fitted[i] || held_out[i] ? logs : given.others).push_back(std::move(given.logs[i]));
  given.logs = std::move(logs);
  if (given.others.empty()) return;
  const auto surplus = std::ranges::count_if(given.others, &Trajectory::held_out);
  const auto held = std::ranges::count_if(given.logs, &Trajectory::held_out);
  in.notes.push_back("of " + std::to_string(before) + " logs, " +
                     std::to_string(given.logs.size() - static_cast<std::size_t>(held)) + " are fitted and " +
                     std::to_string(held) + " held out, those that differ most in bench, gain and goals; " +
                     std::to_string(std::ssize(given.others) - surplus) + " others show which effects predict better" +
                     (surplus > 0 ? ", " + std::to_string(surplus) + " more are only reported" : ""));
}

void noteAllLogs(FolderCase& in) {
  if (in.given.logs.size() > kManyLogs) in.notes.push_back(std::to_string(in.given.logs.size()) + messages::kManyLogs);
}

}  // namespace darwinop::gap
