// Finds experiment files by name or path.
#pragma once

#include <string>
#include <vector>

namespace darwinop::experiments {

/// Search path: $DARWINOP_EXPERIMENTS, then the experiments installed with the program.
std::vector<std::string> experimentFolders();

/// Paths of all experiments in these folders, sorted by name; the first folder with a name takes precedence.
std::vector<std::string> experimentFiles();

/// The file of an experiment, given by path or name. Throws std::runtime_error with the list of names.
std::string findExperiment(const std::string& name);

}  // namespace darwinop::experiments
