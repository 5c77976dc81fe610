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

/// The folder of the model file, or the first model folder with `xml`, so that a copied shipped model works anywhere.
std::string bodyFolder(const std::string& file, const std::string& xml);

}  // namespace darwinop::twin
