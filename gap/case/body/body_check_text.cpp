// The data check for a terminal.
#include "core/text/formatted.hpp"
#include "core/text/nearest.hpp"
#include "gap/case/body/body_check.hpp"

namespace darwinop::gap {
namespace {

std::string listed(const std::vector<std::string_view>& joints) {
  if (joints.empty()) return "-";
  if (joints.size() == kJoints) return "all";
  return joints.size() > 2 ? std::to_string(joints.size()) : text::listed(joints);
}

std::string upOf(const BodyLog& log) {
  return log.up ? text::formatted("%.2f %.2f %.2f", (*log.up)[0], (*log.up)[1], (*log.up)[2]) : log.lies_on;
}

std::string lineOf(const BodyLog& log, const BodyLogCheck& check) {
  return text::formatted("%-14.14s %-8s %-13s %6.1f %5zu %5zu %6zu %5.1f %-10s %-10s %8.2f  %s\n", log.file.c_str(),
                         log.held_out ? "held out" : "fit", std::string{name(log.setup)}.c_str(), check.duration_s,
                         log.rows(), log.lost_rows + check.late_rows, check.unanswered, check.limp_s,
                         listed(check.limp).c_str(), listed(check.unmoved).c_str(), check.greatest_rate_rad_s,
                         upOf(log).c_str());
}

}  // namespace

std::string asText(const BodyCase& given, const BodyCheck& check) {
  std::string out = text::formatted("%s: whole robot, %zu joints, model %s, %s\n", given.name.c_str(), kJoints,
                                    given.joints.model.name.c_str(),
                                    given.trust.empty() ? "its numbers are exact" : "its numbers have priors");
  out += text::formatted("%-14s %-8s %-13s %6s %5s %5s %6s %5s %-10s %-10s %8s  %s\n", "log", "role", "setup", "s",
                         "rows", "lost", "silent", "limp", "joints", "unmoved", "gyro", "up");
  for (std::size_t i = 0; i < given.logs.size(); ++i) out += lineOf(given.logs[i], check.logs[i]);
  out += "limp: s; silent: positions that are not known; gyro: greatest rate about the median, rad/s\n";
  if (!check.cannot_show.empty()) out += "\nThese data cannot show:\n";
  for (const std::string& sentence : check.cannot_show) out += "  " + sentence + "\n";
  if (!check.warnings.empty()) out += "\nOdd:\n";
  for (const std::string& warning : check.warnings) out += "  " + warning + "\n";
  return out;
}

}  // namespace darwinop::gap
