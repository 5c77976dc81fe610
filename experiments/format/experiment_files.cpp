// Finds experiment files by name or path.
#include "experiments/format/experiment_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string_view>

#include "core/text/joined.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/quantity.hpp"

namespace darwinop::experiments {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> filesByName() {
  std::map<std::string, std::string> files;
  for (const std::string& folder : experimentFolders()) {
    std::error_code unreadable;
    for (const auto& entry : fs::directory_iterator{folder, unreadable})
      if (entry.path().extension() == ".ini") files.emplace(entry.path().stem(), entry.path());
  }
  return files;
}

}  // namespace

std::vector<std::string> experimentFolders() {
  std::vector<std::string> folders;
  if (const char* own = std::getenv("DARWINOP_EXPERIMENTS")) folders.emplace_back(own);
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path delivered = program.parent_path().parent_path() / "share/darwinop/experiments";
  folders.push_back(fs::weakly_canonical(delivered, unknown).string());
  return folders;
}

std::vector<std::string> experimentFiles() {
  const auto files = filesByName();
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (const auto& [name, path] : files) paths.push_back(path);
  return paths;
}

std::string findExperiment(const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(".ini")) {
    if (fs::is_regular_file(name)) return name;
    throw std::runtime_error("there is no experiment file " + name);
  }
  const auto files = filesByName();
  if (const auto found = files.find(name); found != files.end()) return found->second;
  if (fs::is_regular_file(name + ".ini"))
    throw std::runtime_error("there is no included experiment '" + name + "'" + messages::kOwnExperiment + name +
                             ".ini");
  std::vector<std::string_view> names;
  names.reserve(files.size());
  for (const auto& [known, path] : files) names.push_back(known);
  throw std::runtime_error("there is no experiment '" + name + "'" + didYouMean(name, names) + "; there are " +
                           (names.empty() ? "none in " + experimentFolders().back() : text::joined(names)) +
                           ". Name your own file by its path: ./mine.ini");
}

}  // namespace darwinop::experiments
