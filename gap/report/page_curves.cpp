// What the page draws.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json/json_text.hpp"
#include "gap/report/html.hpp"
#include "gap/report/page_sections.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

constexpr double kTimeUnit = 1e-4, kAngleUnit = 1e-5;  // s, rad; an encoder's step is 150 of them

/// Whole numbers are short, and the same on every machine.
json inUnits(const std::vector<double>& values, double unit) {
  json all = json::array();
  for (const double value : values)
    all.push_back(std::isfinite(value) ? json(std::llround(value / unit)) : json(nullptr));
  return all;
}

}  // namespace

std::string curvesAsJson(const Report& report) {
  json logs = json::array();
  for (const LogComparison& one : report.comparison.logs) {
    const Trajectory& log = report.given->logs[one.log];
    logs.push_back({{"file", log.file},
                    {"kind", log.kind},
                    {"held_out", log.held_out},
                    {"gap_mrad", mradOf(one.gap.before_rad)},
                    {"floor_mrad", mradOf(one.gap.floor_rad)},
                    {"t", inUnits(log.time_s, kTimeUnit)},
                    {"goal", inUnits(log.goal_rad, kAngleUnit)},
                    {"measured", inUnits(log.position_rad, kAngleUnit)},
                    {"before", inUnits(one.before_rad, kAngleUnit)},
                    {"after", inUnits(one.after_rad, kAngleUnit)}});
  }
  const json all{{"time_unit_s", kTimeUnit}, {"angle_unit_rad", kAngleUnit}, {"logs", logs}};
  return html::inScript(jsonText(all));
}

}  // namespace darwinop::gap
