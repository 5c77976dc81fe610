// The files of a folder of logs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace darwinop::gap {

/// Regular files with this ending (".csv"), by name. Throws BadInput if the folder cannot be read.
std::vector<std::filesystem::path> filesEndingWith(const std::string& folder, const char* end);

/// "bench" of "logs/bench/".
std::string nameOfFolder(const std::string& folder);

}  // namespace darwinop::gap
