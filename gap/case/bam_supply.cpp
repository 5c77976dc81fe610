// Supply of BAM logs without `vin`: never a guess, since all torques are proportional to it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/case/bam_log.hpp"
#include "gap/case/contradictions.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

// Of a supply of servos; 0 is a register that was not read, and more is another unit.
constexpr double kLeastSupply = 3, kGreatestSupply = 30;  // V

std::string volts(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.3g V", value))};
}

/// Logs without `vin`, and what each reads without load.
struct Measured {
  Trajectory* log;
  double idle_v;  // NaN: it does not show it
};

/// A log whose `vin` is wrong cannot be corrected otherwise: there may be hundreds.
void takeDeclared(double supply_v, FolderCase& in) {
  const auto others = std::ranges::count_if(
      in.given.logs, [&](const Trajectory& log) { return log.supply_v && *log.supply_v != supply_v; });
  for (Trajectory& log : in.given.logs) log.supply_v = supply_v;
  in.given.model.servo.supply_v = supply_v;
  if (others > 0)
    in.notes.push_back("the declared supply, " + volts(supply_v) + messages::kReplacesVin + std::to_string(others) +
                       " logs");
}

}  // namespace

std::string takeSupply(const Declarations& declared, FolderCase& in) {
  if (const std::optional<double> supply_v = declared.number("supply_V")) {
    takeDeclared(*supply_v, in);
    return "";
  }
  std::vector<Measured> without;
  for (Trajectory& log : in.given.logs)
    if (!log.supply_v) without.push_back({.log = &log, .idle_v = idleVoltage(log)});
  if (without.empty()) return "";
  std::vector<double> known;
  for (const Measured& one : without)
    if (one.idle_v >= kLeastSupply && one.idle_v <= kGreatestSupply) known.push_back(one.idle_v);
  const std::string list = Declarations::missing("supply_V", "of the logs without `vin`");
  if (known.empty()) return list;
  std::ranges::sort(known);
  const double middle = known[known.size() / 2];
  const bool one_bench = known.back() - known.front() <= kOneBench * middle;
  if (!one_bench && known.size() < without.size()) return list;
  for (const Measured& one : without) one.log->supply_v = one_bench ? middle : one.idle_v;
  in.given.model.servo.supply_v = *in.given.logs.front().supply_v;
  in.notes.push_back(std::to_string(without.size()) + messages::kSupplyMeasured + volts(known.front()) +
                     (one_bench ? "" : " to " + volts(known.back())) + "; if it was another, --declare supply_V=...");
  return "";
}

}  // namespace darwinop::gap
