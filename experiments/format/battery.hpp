// Where experiments are: those that are delivered, and files of one's own.
#pragma once

#include <string>
#include <vector>

namespace darwinop::experiments {

/// Folders that are looked through: $DARWINOP_EXPERIMENTS, then what is delivered beside the program.
std::vector<std::string> batteryFolders();

/// Paths of all experiments there, by name; the first folder that has a name wins.
std::vector<std::string> batteryFiles();

/// The file of an experiment: a path, or the name of a delivered one. Throws std::runtime_error with the names.
std::string findExperiment(const std::string& name);

}  // namespace darwinop::experiments
