// An experiment as the text of a file that `darwinop experiment run` takes: the inverse of its reader.
#pragma once

#include <string>
#include <vector>

#include "experiments/format/experiment.hpp"

namespace darwinop::gap {

/// `comments`: lines above it, without their ';'. A sweep is written out, round after round.
std::string experimentText(const experiments::Experiment& experiment, const std::vector<std::string>& comments);

}  // namespace darwinop::gap
