// Looks at all logs.
#include "gap/case/data_check.hpp"

#include <algorithm>
#include <cmath>

#include "gap/case/bad_rows.hpp"
#include "gap/case/excitation.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/median.hpp"
#include "gap/case/plausible.hpp"
#include "gap/case/repeat_spread.hpp"
#include "gap/case/reveals.hpp"

namespace darwinop::gap {
namespace {

constexpr double kLost = 1.5;  // periods: a row is missing
constexpr double kLostShare = 0.01;
constexpr double kLate = 0.5;  // of a period

/// A host that reads and writes is slower than one that reads, so rows with and without torque have their own period.
void lookAtTime(const Trajectory& log, LogCheck& out) {
  out.period_s = periodOf(log);
  std::vector<double> late;
  for (const int on : {0, 1}) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < log.rows(); ++i)
      if (log.torque_on[i] == on) steps.push_back(log.time_s[i] - log.time_s[i - 1]);
    const double period = medianOf(steps);
    for (const double step : steps) {
      late.push_back(step - period);
      if (step > kLost * period) out.lost_rows += static_cast<std::size_t>(std::lround(step / period)) - 1;
    }
  }
  if (late.empty()) return;
  const auto at = late.begin() + static_cast<std::ptrdiff_t>(late.size() * 99 / 100);
  std::nth_element(late.begin(), at, late.end());
  out.late_s = std::max(0.0, *at);
}

std::string milliseconds(double s) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.1f ms", 1000 * s))};
}

void warn(const LogCheck& log, std::vector<std::string>& warnings) {
  if (double(log.lost_rows) > kLostShare * double(log.rows))
    warnings.push_back(log.file + ": " + std::to_string(log.lost_rows) + " rows are missing between the " +
                       std::to_string(log.rows) + " there are");
  if (log.late_s > kLate * log.period_s)
    warnings.push_back(log.file + ": one row in a hundred is " + milliseconds(log.late_s) +
                       " late or more, with a row every " + milliseconds(log.period_s));
}

}  // namespace

DataCheck checkData(const Case& c) {
  DataCheck out;
  out.warnings = c.warnings;
  out.contradictions = contradictionsOf(c);
  const auto copies = duplicates(c);
  for (std::size_t i = 0; i < c.logs.size(); ++i) {
    const Trajectory& log = c.logs[i];
    LogCheck check;
    check.file = log.file;
    check.kind = log.kind;
    check.held_out = log.held_out;
    check.duplicate_of = copies[i];
    check.rows = log.rows();
    lookAtTime(log, check);
    check.excitation = excitationOf(log, c.model.servo);
    warn(check, out.warnings);
    for (const MaskedReadings& masked : log.masked) out.masked.push_back(asSentence(log, masked));
    if (!copies[i]) (log.held_out ? out.held_out : out.fit).add(check.excitation);
    if (log.repeat_of && !copies[i]) out.has_repeats = true;
    out.logs.push_back(std::move(check));
  }
  out.warnings = grouped(out.warnings);
  out.repeats_rad = repeatSpread(c).rms_rad();
  out.findings = reveals(out, c);
  return out;
}

}  // namespace darwinop::gap
