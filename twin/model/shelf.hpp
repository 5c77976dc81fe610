// Where models are shipped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace darwinop::twin {

/// Folders in the order in which they are searched: $DARWINOP_MODELS, then those of this build or installation.
std::vector<std::string> modelFolders();

/// "the shipped models are darwin-op and webots-2013"
std::string shippedOnes();

bool isFile(const std::filesystem::path& path);

}  // namespace darwinop::twin
