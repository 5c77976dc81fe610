// Notes about many logs, as few lines.
#pragma once

#include <string>
#include <vector>

namespace darwinop::gap {

/// Notes that say the same of several logs, but for their numbers, as one with the number of logs.
std::vector<std::string> grouped(const std::vector<std::string>& notes);

}  // namespace darwinop::gap
