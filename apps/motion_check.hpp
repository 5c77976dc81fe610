// `darwinop motion check`: problems of a motion file on a robot.
#pragma once

#include <string>

namespace darwinop::motion {

/// Prints them. Exit status: 0 none, 1 findings. Throws std::runtime_error if the file cannot be read.
int checkMotions(const std::string& file);

}  // namespace darwinop::motion
