#include "gap/identify/stuck_log.hpp"

#include <vector>

#include "gap/case/repeat_spread.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::size_t> wrongLogsOf(const FittedModel& fitted) {
  std::vector<std::size_t> wrong;
  Eigen::Index begin = 0;
  for (std::size_t i = 0; i < fitted.evidence->logs.size(); ++i) {
    const Eigen::Index size = fitted.evidence->noise[i].size();
    if (fitted.fit.residuals.segment(begin, size).unaryExpr(&costOf).mean() > thresholds::kPlainCost)
      wrong.push_back(fitted.evidence->logs[i]);
    begin += size;
  }
  return wrong;
}

/// True for one log, or logs that repeat each other.
bool areOneMotion(const Case& given, const std::vector<std::size_t>& logs) {
  if (logs.size() < 2) return logs.size() == 1;
  const std::vector<std::vector<std::size_t>> groups = repeatGroups(given, logs);
  return groups.size() == 1 && groups.front().size() == logs.size();
}

}  // namespace

std::optional<FittedModel> fittedPastAStuckLog(const FittedModel& fitted) {
  const std::vector<std::size_t> wrong = wrongLogsOf(fitted);
  const bool all_are = wrong.size() == fitted.evidence->logs.size();
  if (fitted.fit.x.size() == 0 || all_are || !areOneMotion(fitted.study->data, wrong)) return std::nullopt;
  Case others = fitted.study->data;
  for (const std::size_t log : wrong) others.logs[log].held_out = true;
  const Study part{others};
  const FittedModel first = refit(part, fitted.effects, fitted.nuisance, fitted.problem, fitted.fit, 2);
  FittedModel all = refit(*fitted.study, fitted.effects, fitted.nuisance, first.problem, first.fit, 4);
  if (all.total >= fitted.total) return std::nullopt;
  return all;
}

}  // namespace darwinop::gap
