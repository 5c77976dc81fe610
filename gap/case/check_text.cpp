// The check of the data for a terminal.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "gap/case/data_check.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...) {
  std::array<char, 256> text{};
  va_list values;
  va_start(values, format);
  const int length = std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return {text.data(), static_cast<std::size_t>(std::clamp(length, 0, int(text.size()) - 1))};
}

/// "-0.5..0.7", or what stands for nothing.
std::string range(const Extent& extent, const char* format) {
  if (!extent.known()) return "-";
  char text[64];
  std::snprintf(text, sizeof text, format, extent.low, extent.high);
  return text;
}

std::string row(const std::string& name, const Excitation& e) {
  return printed(
      "%-14.14s %6.1f %6.1f %5.1f %5.1f %5d %13s %6s %11s %11s %7s\n", name.c_str(), e.duration_s, e.limp_s,
      e.at_rest_s, e.slow_s, e.reversals, range(e.position_rad, "%.2f..%.2f").c_str(),
      e.speed_rad_s.known() ? printed("%.2f", e.speed_rad_s.greatest()).c_str() : "-",
      e.load.known() ? printed("%ld..%ld", std::lround(100 * e.load.low), std::lround(100 * e.load.high)).c_str() : "-",
      range(e.volt_v, "%.1f..%.1f").c_str(), range(e.temp_c, "%.0f..%.0f").c_str());
}

std::string listed(const std::set<double>& values) {
  std::string text;
  for (const double value : values) text += printed("%s%g", text.empty() ? "" : ", ", value);
  return text;
}

double share(const Excitation& e) {
  return e.powered_s > 0 ? 100 * e.saturated_s / e.powered_s : 0;
}

std::string timing(const DataCheck& check) {
  Extent period, late;
  std::size_t lost = 0, rows = 0;
  for (const LogCheck& log : check.logs) {
    period.add(1000 * log.period_s);
    late.add(1000 * log.late_s);
    lost += log.lost_rows;
    rows += log.rows;
  }
  return printed("rows: %zu, %zu lost; one every %.1f to %.1f ms, 99 %% at most %.1f ms late\n", rows, lost, period.low,
                 period.high, late.high);
}

}  // namespace

std::string asText(const DataCheck& check) {
  std::string out = printed("%-14s %6s %6s %5s %5s %5s %13s %6s %11s %11s %7s\n", "log", "s", "limp", "rest", "slow",
                            "turns", "position rad", "rad/s", "load %", "V", "degC");
  for (const LogCheck& log : check.logs) out += row(log.file, log.excitation);
  out += row("fit, all", check.fit);
  if (check.held_out.duration_s > 0) out += row("held out, all", check.held_out);
  out += timing(check);
  out += printed("fit: payload %s kg, P register %s, %.1f %% of the time under torque at full load, session %s s\n",
                 listed(check.fit.payloads_kg).c_str(), listed(check.fit.p_registers).c_str(), share(check.fit),
                 range(check.fit.session_s, "%.0f to %.0f").c_str());
  if (check.repeats_rad >= 0) out += printed("repeats differ by %.2f mrad\n", 1e3 * check.repeats_rad);
  for (const bool reveals : {true, false}) {
    out += std::string{"\n"} + (reveals ? messages::kCanReveal : messages::kCannotReveal) + "\n";
    bool any = false;
    for (const DataFinding& finding : check.findings) {
      if (finding.reveals != reveals) continue;
      any = true;
      out += "  " + finding.sentence + "\n";
      if (!finding.remedy.empty()) out += "    -> " + std::string{finding.remedy} + "\n";
    }
    if (!any) out += "  nothing of what is looked at here\n";
  }
  if (!check.contradictions.empty()) out += std::string{"\n"} + messages::kContradictions + "\n";
  for (const Contradiction& found : check.contradictions) out += "  " + asSentence(found) + "\n";
  if (!check.masked.empty()) out += std::string{"\n"} + messages::kMaskedReadings + "\n";
  for (const std::string& masked : check.masked) out += "  " + masked + "\n";
  if (!check.warnings.empty()) out += "\nOdd:\n";
  for (const std::string& warning : check.warnings) out += "  " + warning + "\n";
  return out;
}

}  // namespace darwinop::gap
