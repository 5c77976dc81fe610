// Loop statistics as text.
#include "runtime/report.hpp"

#include <cmath>

#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

struct Figures {
  double wake_p50, wake_p99, wake_max;            // us
  double bus_p50, bus_p99, bus_max, wire, ratio;  // ms, ratio without unit
};

Figures figures(const StatsView& stats) {
  constexpr double kMs = 1e-3;
  Figures f{stats.wake.percentile(0.5),
            stats.wake.percentile(0.99),
            stats.wake.max(),
            stats.bus.percentile(0.5) * kMs,
            stats.bus.percentile(0.99) * kMs,
            stats.bus.max() * kMs,
            stats.wire.percentile(0.5) * kMs,
            0};
  f.ratio = f.bus_p50 / f.wire;
  return f;
}

std::string shown(double value, int digits, const char* unit) {
  return std::isnan(value) ? "not measured" : text::fixedText(value, digits) + unit;
}

std::string staleText(const Sensors& sensors) {
  const std::vector<std::string> stale = staleDevices(sensors);
  return stale.empty() ? "none" : text::joined(stale);
}

}  // namespace

std::vector<std::string> staleDevices(const Sensors& sensors) {
  std::vector<std::string> stale;
  if (!sensors.board.absent && sensors.board.motion.stale()) stale.emplace_back("CM-730");
  for (std::size_t i = 0; i < kJoints; ++i)
    if (sensors.joint[i].motion.stale()) stale.emplace_back(kJointTable[i].name);
  return stale;
}

std::string reportLine(const StatsView& stats, const Sensors& last) {
  const Figures f = figures(stats);
  return "report: cycles=" + std::to_string(stats.cycles) + " overruns=" + std::to_string(stats.overruns) +
         " wake_p50_us=" + text::fixedText(f.wake_p50, 0) + " wake_p99_us=" + text::fixedText(f.wake_p99, 0) +
         " wake_max_us=" + text::fixedText(f.wake_max, 0) + " bus_ms_median=" + text::fixedText(f.bus_p50, 3) +
         " wire_ms=" + text::fixedText(f.wire, 3) + " bus_ratio=" + text::fixedText(f.ratio, 3) +
         " retries=" + std::to_string(stats.retries) +
         " stale=" + std::to_string(stats.cycles == 0 ? 0 : staleDevices(last).size());
}

std::string reportText(const StatsView& stats, const Sensors& last) {
  if (stats.cycles == 0) return messages::kNoCycle;
  const Figures f = figures(stats);
  const double seconds = stats.cycles * static_cast<double>(last.period_ns) * 1e-9;
  return "cycles        " + std::to_string(stats.cycles) + " (" + text::fixedText(seconds, 1) + " s at " +
         text::fixedText(static_cast<double>(last.period_ns) * 1e-6, 1) + " ms)\n" + "overruns      " +
         std::to_string(stats.overruns) + ", releases skipped " + std::to_string(stats.skipped) + "\n" +
         "wake latency  median " + shown(f.wake_p50, 0, " us") + ", p99 " + shown(f.wake_p99, 0, " us") + ", max " +
         shown(f.wake_max, 0, " us") + "\n" + "bus time      median " + shown(f.bus_p50, 2, " ms") + ", p99 " +
         shown(f.bus_p99, 2, " ms") + ", max " + shown(f.bus_max, 2, " ms") + "\n" + "wire time     median " +
         shown(f.wire, 2, " ms") + ", the limit; bus time is " + shown(f.ratio, 3, " times that") + "\n" +
         "slack         median " + shown(stats.slack.percentile(0.5) * 1e-3, 2, " ms") + ", p1 " +
         shown(stats.slack.percentile(0.01) * 1e-3, 2, " ms") + "\n" + "answers       incomplete " +
         std::to_string(stats.incomplete) + ", late " + std::to_string(stats.late_replies) + ", retries " +
         std::to_string(stats.retries) + ", reconnects " + std::to_string(stats.reconnects) + "\n" + "stale devices " +
         staleText(last) + "\n" +
         (last.link.clamped_goals == 0 ? ""
                                       : "goals kept within the joint table at the wire: " +
                                             std::to_string(last.link.clamped_goals) + " (a bug; please report it)\n");
}

std::string robotText(const Sensors& last) {
  const std::string state{kStateNames[static_cast<std::size_t>(last.safety.state)]};
  std::string text = "state         " + state + "\n";
  for (std::size_t i = 0; i < kFaults; ++i) {
    if (!last.safety.active[i]) continue;
    const FaultRow& fault = kFaultTable[i];
    text += "fault         " + std::to_string(static_cast<int>(fault.fault)) + " " + std::string{fault.name} + ": " +
            std::string{fault.meaning};
    if (fault.fault == last.safety.worst && last.safety.worst_joint >= 1 && last.safety.worst_joint <= kJoints)
      text += " (" + std::string{kJointTable[last.safety.worst_joint - 1U].name} + ")";
    text += "\n  what to do  " + std::string{fault.remedy} + "\n";
  }
  if (last.safety.active.none()) text += "faults        none\n";
  if (last.board.absent) return text + messages::kNoBoard;
  return text + "battery       " + shown(last.board.voltage.value, 1, " V") + "\n";
}

}  // namespace darwinop::runtime
