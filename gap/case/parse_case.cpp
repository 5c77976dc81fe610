// A case.json from top to bottom.
#include "gap/case/parse_case.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "gap/case/bad_rows.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLogs = 1000;

std::vector<LogEntry> readEntries(Fields& top, std::vector<std::string>& warnings) {
  std::vector<LogEntry> entries;
  std::vector<Fields> list = top.list("logs");
  if (list.size() > kMostLogs) top.fail("logs", "has more than 1000 entries; make several cases of it");
  for (Fields& entry : list) {
    entries.push_back(readLogEntry(entry, warnings));
    for (std::size_t i = 0; i + 1 < entries.size(); ++i)
      if (entries[i].head.file == entries.back().head.file && !(entries[i].to_s < entries.back().from_s) &&
          !(entries.back().to_s < entries[i].from_s))
        entry.fail("file", std::string{messages::kGivenTwice} + "; keep one of the two");
    if (entries.back().joint != entries.front().joint)
      entry.fail("joint", std::string{messages::kOtherJoint} + "; a case is of one joint");
  }
  const bool fit =
      std::ranges::any_of(entries, [](const LogEntry& entry) { return !entry.head.held_out && !entry.is_other; });
  if (!fit) top.fail("logs", std::string{messages::kNoFitLog} + "; there is nothing to learn from");
  return entries;
}

/// The first log of a series of repeats.
void linkRepeats(Fields& top, std::vector<LogEntry>& entries) {
  std::vector<std::optional<std::size_t>> of(entries.size());
  const auto name_of = [](std::size_t i) { return "logs[" + std::to_string(i) + "].repeat_of"; };
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].repeats.empty()) continue;
    const auto found =
        std::ranges::find_if(entries, [&](const LogEntry& e) { return e.head.file == entries[i].repeats; });
    if (found == entries.end())
      top.fail(name_of(i), std::string{messages::kRepeatOfNothing} + "; it has to be the file of one");
    of[i] = static_cast<std::size_t>(found - entries.begin());
    if (found->is_other || entries[i].is_other)
      top.fail(name_of(i), std::string{messages::kRepeatOfAnother} + "; only fit and held_out have repeats");
    if (of[i] == i) top.fail(name_of(i), std::string{messages::kRepeatOfItself} + "; name the one before");
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::optional<std::size_t> first = of[i];
    for (std::size_t steps = 0; first && of[*first]; ++steps, first = of[*first])
      if (steps > entries.size()) top.fail(name_of(i), "is circular; name the first log");
    entries[i].head.repeat_of = first;
  }
}

/// Logs and others, each in the order of the entries.
void append(std::vector<LogEntry>& entries, Case& into) {
  std::vector<std::size_t> index;  // of an entry in `logs`
  for (LogEntry& entry : entries) {
    index.push_back(into.logs.size());
    (entry.is_other ? into.others : into.logs).push_back(std::move(entry.head));
  }
  for (Trajectory& log : into.logs)
    if (log.repeat_of) log.repeat_of = index[*log.repeat_of];
}

void takeOrder(Fields& top, bool recording, Case& into) {
  const std::vector<std::string_view> words{"after_read", "before_read"};
  const auto order = static_cast<GoalOrder>(top.word("goal_order", words, 0));
  if (recording && order == GoalOrder::kBeforeRead)
    top.fail("goal_order",
             "is before_read, but a goal of a recording of the runtime acts from the row's read on, after_read; take "
             "the key away");
  into.goal_order = order;
}

/// That of the case, or of its recordings. An arm of another kind has names of its own, which say nothing here.
void takeJoint(Fields& top, const std::vector<LogEntry>& entries, Case& into) {
  into.joint = entries.front().joint;
  if (!top.has("joint")) return;
  const std::string name = top.text("joint");
  const std::optional<Joint> whole = findJoint(name);
  if (!whole) into.warnings.push_back("joint " + name + messages::kOfAnotherRobot);
  if (whole && into.joint && whole != into.joint)
    top.fail("joint", std::string{messages::kOtherJoint} + "; keep one of the two");
  if (whole) into.joint = whole;
}

/// An arm that turns about a vertical axis has inertia and no weight.
void takeAxis(Fields& top, Case& into) {
  const std::vector<std::string_view> words{"horizontal", "vertical"};
  if (top.word("axis", words, 0) == 1) into.pendulum.gravity_m_s2 = 0;
}

/// Takes the rows of a log. What is wrong with it, if anything.
std::optional<BadInput> fill(LogEntry& entry, Fields& top, const Encodings& raw, const CaseFiles& files, Case& into) {
  try {
    const logs::Log log = loadLog(files, entry.head.file);
    into.warnings.insert(into.warnings.end(), log.warnings.begin(), log.warnings.end());
    fillTrajectory(log, raw, entry, into.warnings);
    takeOrder(top, log.recording || entry.head.isReadAfterWrite(), into);
    if (files.leave_out) {
      Trajectory copy = entry.head;
      checkLog(copy, log.file, into);
    } else {
      checkLog(entry.head, log.file, into);
    }
    return std::nullopt;
  } catch (const BadInput& reason) {
    return reason;
  }
}

/// Those that can be used; none if all are left out.
std::vector<LogEntry> filled(std::vector<LogEntry> entries, Fields& top, const Encodings& raw, const CaseFiles& files,
                             Case& into) {
  std::vector<LogEntry> usable;
  for (LogEntry& entry : entries) {
    const std::optional<BadInput> wrong = fill(entry, top, raw, files, into);
    if (!wrong) {
      usable.push_back(std::move(entry));
      continue;
    }
    if (!files.leave_out) throw BadInput{*wrong};
    files.leave_out(*wrong);
  }
  return usable;
}

}  // namespace

void checkLog(Trajectory& log, const std::string& file, Case& of) {
  checkRows(log, file);
  maskBadRows(log, file, of);
  checkUnits(log, file, of);
  checkSensor(log, file, of);
  dropMissingLoad(log, file, of);
  dropOddLoad(log, file, of);
  checkLoadSign(log, file, of);
}

logs::Log loadLog(const CaseFiles& files, const std::string& name) {
  try {
    return files.log(name);
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
}

Case parseCase(std::string_view json, const std::string& file, const CaseFiles& files) {
  const Json parsed = parseJson(json, file);
  Fields top{parsed, file, ""};
  Case out;
  const fs::path path{file};
  out.folder = path.parent_path().empty() ? "." : path.parent_path().string();
  out.name = top.text("case", path.parent_path().filename().string());
  if (out.name.empty()) out.name = "case";
  // The name of a model has these limits.
  if (out.name.size() > 120 || out.name.find_first_of("\"';#\n\r") != std::string::npos)
    top.fail("case", std::string{messages::kInvalidName} + "; use 1 to 120 characters without quotes, ; and #");
  if (isWholeRobot(parsed)) top.fail("family", messages::kWholeRobot);
  for (const std::string_view key :
       {"family", "columns", "host_dt_s", "goal_order", "servo_datasheet", "prior_rel_sigma"})
    top.leave(key);
  std::vector<LogEntry> entries = readEntries(top, out.warnings);
  linkRepeats(top, entries);
  const Encodings raw = readEncodings(top);
  for (const LogEntry& entry : entries) out.logs.push_back(entry.head);
  takeJoint(top, entries, out);
  readModelPart(top, files, out.joint, out);
  takeAxis(top, out);
  out.logs.clear();
  top.finish(out.warnings);

  std::vector<LogEntry> usable = filled(std::move(entries), top, raw, files, out);
  append(usable, out);
  const auto clockless = std::ranges::count_if(usable, [](const LogEntry& e) { return !e.session_start_s; });
  if (clockless > 0 && usable.size() > 1)
    out.warnings.push_back(file +
                           ": logs without t0_session_s count as the first of the session; what wears and warms "
                           "cannot be seen then");
  checkRepeats(out);
  smoothTemperatures(out);
  out.warnings = grouped(out.warnings);
  return out;
}

}  // namespace darwinop::gap
