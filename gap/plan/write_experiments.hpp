// The best experiments as files for `darwinop experiment run`.
#pragma once

#include <string>
#include <vector>

#include "gap/plan/ranking.hpp"

namespace darwinop::gap {

/// Text of the file of one of the ranked: what it is for, what to prepare, how to run it and to make a case of it.
std::string fileOf(const NextExperiments& next, const Ranked& ranked);

/// Writes FOLDER/NAME.ini for the best ones; the paths. Makes the folder. Throws std::runtime_error.
std::vector<std::string> writeBest(const NextExperiments& next, const std::string& folder, std::size_t most = 3);

/// "darwinop experiment run DIR/steps.ini --record steps.csv"
std::string commandFor(const std::string& path);

}  // namespace darwinop::gap
