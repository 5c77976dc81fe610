// The message "loop": loop statistics.
#include <array>
#include <utility>

#include "monitor/json.hpp"
#include "monitor/messages.hpp"
#include "runtime/report.hpp"

namespace darwinop::monitor {
namespace {

constexpr std::array<std::uint32_t, 10> kEdges{10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};  // us

std::uint32_t countBetween(const runtime::HistogramView& view, std::uint32_t low, std::uint32_t high) {
  std::uint32_t sum = 0;
  for (std::size_t bin = 0; bin < runtime::Bins::kCount; ++bin)
    if (runtime::Bins::low(bin) >= low && runtime::Bins::low(bin) < high) sum += view.count[bin];
  return sum;
}

Json histogramOf(const runtime::HistogramView& view) {
  Json counts = Json::array();
  std::uint32_t low = 0;
  for (const std::uint32_t edge : kEdges) counts.push_back(countBetween(view, std::exchange(low, edge), edge));
  counts.push_back(countBetween(view, low, UINT32_MAX));
  return {{"edges_us", kEdges}, {"counts", std::move(counts)}};
}

Json spread(const runtime::HistogramView& view, double unit) {
  return {{"p50", rounded(view.percentile(0.5) * unit)},
          {"p99", rounded(view.percentile(0.99) * unit)},
          {"max", rounded(view.max() * unit)}};
}

Json driverOf(pid_t pid) {
  if (pid == 0) return nullptr;
  Json driver;
  driver["pid"] = pid > 0 ? Json(pid) : Json(nullptr);
  return driver;
}

}  // namespace

std::string loopText(const LoopFigures& figures, const Sensors& seen) {
  const runtime::StatsView &all = figures.all, &recent = figures.recent;
  constexpr double kMs = 1e-3;
  Json text;
  text["type"] = "loop";
  text["cycles"] = all.cycles;
  text["overruns"] = all.overruns;
  text["skipped"] = all.skipped;
  text["retries"] = all.retries;
  text["incomplete"] = all.incomplete;
  text["late_replies"] = all.late_replies;
  text["reconnects"] = all.reconnects;
  text["bad_checksums"] = seen.link.bad_checksums;
  text["garbage_bytes"] = seen.link.garbage_bytes;
  text["recent"] = {{"seconds", rounded(figures.seconds, 1e3)},
                    {"cycles", recent.cycles},
                    {"overruns", recent.overruns},
                    {"skipped", recent.skipped},
                    {"retries", recent.retries},
                    {"incomplete", recent.incomplete},
                    {"wake_us", spread(recent.wake, 1)}};
  text["wake_us"] = spread(all.wake, 1);
  text["bus_ms"] = spread(all.bus, kMs);
  text["wire_ms"] = {{"p50", rounded(all.wire.percentile(0.5) * kMs)}};
  text["slack_ms"] = {{"p1", rounded(all.slack.percentile(0.01) * kMs)},
                      {"p50", rounded(all.slack.percentile(0.5) * kMs)}};
  text["wake_histogram"] = histogramOf(all.wake);
  text["stale"] = runtime::staleDevices(seen);
  Json& hits = text["limit_hits"];
  for (std::size_t i = 0; i < kLimits; ++i) hits[std::string{kLimitNames[i]}] = seen.safety.limit_hits[i];
  text["driver"] = driverOf(figures.driver);
  text["session"] = figures.session;
  text["lost"] = figures.lost;
  return jsonText(text);
}

}  // namespace darwinop::monitor
