// Logs of the public project BAM (better actuator models, github.com/Rhoban/bam): one JSON file a log, with the bench
// in the head and one object a row. Read into a log of a case, and written from one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {

inline constexpr std::size_t kLongestBamLog = std::size_t{1} << 28;  // bytes

struct BamLog {
  Trajectory log;                    // its load: convertLoads(); its lines: indices of entries
  std::string motor;                 // "mx106"
  std::vector<std::string> notes;    // what was recognized in the file, and by what
  std::vector<double> load, torque;  // as they are in the file, which does not give their unit
};

/// Keys of the head: mass, arm_mass, length, kp, vin, motor, trajectory, entries; of an entry: timestamp,
/// goal_position, torque_enable, position, and where they are there speed, load or torque, input_volts, temp, current.
/// `name` of the log: the file without its ending. Throws BadInput.
BamLog parseBamLog(std::string_view json, const std::string& file, const std::string& name);

/// Leaves out speed, voltage and temperature that are in another unit.
void dropOddColumns(BamLog& log);

/// Fills the loads of the logs of one servo. Their unit and sign follow from the columns of all of them: a log of small
/// loads does not show it. `torque` stands for a load that is 0 everywhere.
void convertLoads(std::vector<BamLog>& logs);

/// The same format; a value that is not known is left out.
std::string asBamJson(const Case& c, const Trajectory& log, std::string_view motor);

/// Leaves the logs of one motor: the declared one, else the one of nine in ten. A declared one is also that of logs
/// without a name, or of all if they have one name. Returns it. Throws BadInput.
std::string keepOneMotor(const std::optional<std::string>& declared, const std::string& folder,
                         std::vector<BamLog>& logs, std::vector<std::string>& notes);

/// All *.json of a folder, by name, as a case whose servo is that of a model file, or of a shipped model's name. Throws
/// BadInput.
FolderCase readBamFolder(const std::string& folder, const std::string& model, const Declarations& declared);

/// Reads the logs again with what is declared of them, and leaves out those that cannot be used.
void checkBamLogs(const Declarations& declared, FolderCase& in);

/// Gives all logs the declared supply, else those without `vin` the voltage that they read without load, with a note.
/// Returns what has to be declared; empty: nothing.
std::string takeSupply(const Declarations& declared, FolderCase& in);
}  // namespace darwinop::gap
