#include "gap/case/write_time.hpp"

#include <string>

#include "core/text/formatted.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

void set(double before_s, Trajectory& log) {
  const std::string what = "--declare " + std::string{kWriteTimeKey} + ": " + log.file + ": ";
  if (log.isReadAfterWrite()) throw BadInput(what + messages::kHasWriteTimes);
  if (const double period_s = periodOf(log); !(before_s > 0 && before_s < period_s))
    throw BadInput(what + text::formatted(messages::kBeyondItsRow, 1e3 * period_s));
  // The clock of a log has no zero of its own: it begins at the write instead of the read. The firmware is not in step
  // with it (Trajectory::is_phase_known), as in every log that does not say so.
  log.written_s.assign(log.rows(), 0);
  log.read_s.assign(log.rows(), before_s);
}

}  // namespace

void setWriteTime(double before_s, Case& into) {
  if (into.goal_order != GoalOrder::kBeforeRead)
    throw BadInput(std::string{"--declare "} + kWriteTimeKey + messages::kOfBeforeRead);
  for (Trajectory& log : into.logs) set(before_s, log);
  for (Trajectory& log : into.others) set(before_s, log);
  into.goal_order = GoalOrder::kAfterRead;
}

}  // namespace darwinop::gap
