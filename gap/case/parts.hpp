// The parts of a case.json, each read by a file of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/joints.hpp"
#include "gap/case/case.hpp"
#include "gap/case/encodings.hpp"
#include "gap/case/fields.hpp"
#include "gap/case/parse_case.hpp"

namespace darwinop::gap {

/// `baseline`, or `model` and `arm`; `servo_datasheet`; `prior_rel_sigma`. `joint`: whose effects count when the model
/// file has some for single joints. `into` has the logs' entries: arm numbers that all of them have may be left out.
void readModelPart(Fields& top, const CaseFiles& files, std::optional<Joint> joint, Case& into);

/// What a sheet does not say is as in the baseline.
Datasheet readDatasheet(Fields sheet, const twin::ServoParameters& baseline, std::vector<std::string>& warnings);
inline constexpr twin::NumberRule kRelativeSigma{"", 1e-6, 10};

/// `encodings`: of raw columns, by the name of the column ("load_raw").
using Encodings = std::map<std::string, const Encoding*, std::less<>>;
Encodings readEncodings(Fields& top);

/// One entry of `logs`.
struct LogEntry {
  Trajectory head;  // without rows
  bool is_other = false;
  std::string repeats;  // name of a log; empty: none
  std::optional<double> p_register;
  std::optional<double> session_start_s;
  std::optional<Joint> joint;  // whose columns of a recording
  double from_s, to_s;         // of the file's own clock
  bool firmware_in_step;       // of a plain log with written_s and read_s
  double hangs_at_rad;         // angle of the joint at which the arm hangs down; a case counts from there
};
LogEntry readLogEntry(Fields& entry, std::vector<std::string>& warnings);
/// Of an entry: `file`, which must be in the folder, and `role`.
std::string logFileIn(Fields& entry);
enum class EntryRole : std::uint8_t { kFit, kHeldOut, kValidation, kOther };
EntryRole roleIn(Fields& entry);

/// The rows of a log. A recording of the runtime, docs/logs.md, also has some values of `entry`. Throws
/// BadInput for a column that is missing or has a wrong unit, and for a value that is missing. `raw`: of columns with
/// counts.
void fillTrajectory(const logs::Log& log, const Encodings& raw, LogEntry& entry, std::vector<std::string>& warnings);
void fillFromRecording(const logs::Log& log, LogEntry& entry, std::vector<std::string>& warnings);

/// Fills warmth_c of all logs: temperature changes slowly, so smoothing resolves less than the register's 1 degC.
void smoothTemperatures(Case& of);

}  // namespace darwinop::gap
