// Folders with shipped models.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace darwinop::twin {

/// In search order: $DARWINOP_MODELS, then those of this build or installation.
std::vector<std::string> modelFolders();

/// "the shipped models are darwin-op and webots-2013"
std::string listShippedModels();

bool isFile(const std::filesystem::path& path);

}  // namespace darwinop::twin
