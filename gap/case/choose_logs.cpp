// Which logs of a large folder are searched: the time of a search grows with each, and the tenth log of one bench, gain
// and motion teaches little.
#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/case/log_traits.hpp"
#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

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

/// Of the logs that are not held out those that are least alike, one after the other; at a tie the first of the folder.
/// Poor ones differ from all others, and come last.
std::vector<bool> fittedOf(const std::vector<Trajectory>& logs) {
  std::vector<bool> fitted(logs.size());
  std::vector<std::size_t> left;
  std::vector<LogTraits> traits, chosen;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    traits.push_back(traitsOf(logs[i]));
    if (!logs[i].held_out) left.push_back(i);
  }
  const std::vector<bool> poor = poorOf(logs);
  double seconds = 0;
  while (chosen.size() < kMostFitLogs && (chosen.size() < kFewestChosen || seconds < kMostFitSeconds) &&
         !left.empty()) {
    const auto next = std::ranges::min_element(left, {}, [&](std::size_t i) {
      return std::pair{static_cast<bool>(poor[i]), likeness(traits[i], chosen)};
    });
    fitted[*next] = true;
    chosen.push_back(traits[*next]);
    seconds += logs[*next].duration_s();
    left.erase(next);
  }
  return fitted;
}

}  // namespace

void chooseLogs(FolderCase& in) {
  Case& given = in.given;
  const std::size_t before = given.logs.size();
  const std::vector<bool> fitted = fittedOf(given.logs);
  std::vector<Trajectory> logs;
  for (std::size_t i = 0; i < before; ++i)
    (fitted[i] || given.logs[i].held_out ? logs : given.others).push_back(std::move(given.logs[i]));
  given.logs = std::move(logs);
  if (given.others.empty()) return;
  in.notes.push_back("of " + std::to_string(before) + " logs, " + std::to_string(std::ranges::count(fitted, true)) +
                     " are fitted, those that differ most in bench, gain and goals; " +
                     std::to_string(given.others.size()) + " others test what is found");
}

void noteAllLogs(FolderCase& in) {
  if (in.given.logs.size() > kManyLogs) in.notes.push_back(std::to_string(in.given.logs.size()) + messages::kManyLogs);
}

}  // namespace darwinop::gap
