// Finds model files by path, or by name in the model folders.
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "core/text/nearest.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/model.hpp"
#include "twin/model/shipped.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".ini";

/// The file that contains this code (a program or the twin's shared library), then the running program. A controller
/// may be installed in another place than the twin that it loads.
std::vector<fs::path> runningFiles() {
  std::vector<fs::path> files;
  std::error_code failed;
  Dl_info here{};
  const auto* const self = reinterpret_cast<const void*>(&modelFolders);
  if (dladdr(self, &here) != 0 && here.dli_fname != nullptr)
    if (const fs::path file = fs::canonical(here.dli_fname, failed); !failed) files.push_back(file);
  if (const fs::path file = fs::read_symlink("/proc/self/exe", failed); !failed) files.push_back(file);
  return files;
}

bool isIn(const fs::path& file, const fs::path& folder) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

}  // namespace

bool isFile(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(path, failed);
}

std::vector<std::string> modelFolders() {
  std::vector<std::string> folders;
  if (const char* const named = std::getenv("DARWINOP_MODELS"); named != nullptr && *named != '\0')
    folders.emplace_back(named);
  for (const fs::path& file : runningFiles()) {
    if (isIn(file, DARWINOP_BUILD_FOLDER)) folders.emplace_back(DARWINOP_SOURCE_MODELS);
    std::error_code failed;
    for (fs::path above = file.parent_path(); above != above.root_path(); above = above.parent_path())
      if (const fs::path models = above / "share/darwinop/models"; fs::is_directory(models, failed))
        folders.push_back(models.string());
  }
  return folders;
}

std::string bodyFolder(const std::string& file, const std::string& xml) {
  std::string own = fs::path{file}.parent_path().string();
  std::vector<std::string> folders{own};
  for (const std::string& models : modelFolders()) folders.push_back(models);
  for (const std::string& folder : folders)
    if (isFile(fs::path{folder} / xml)) return folder;
  return own;
}

std::vector<std::string> shippedModels() {
  std::set<std::string> names;
  for (const std::string& folder : modelFolders()) {
    std::error_code failed;
    for (fs::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed))
      if (at->path().extension() == kExtension && isFile(at->path())) names.insert(at->path().stem().string());
  }
  return {names.begin(), names.end()};
}

std::string listShippedModels() {
  const auto names = shippedModels();
  if (names.empty()) return "no shipped models found; set DARWINOP_MODELS to the folder that contains them";
  const std::vector<std::string_view> views(names.begin(), names.end());
  return "the shipped models are " + text::listed(views);
}

std::string findModel(const std::string& name) {
  const bool is_path = name.find('/') != name.npos || name.ends_with(kExtension);
  if (is_path || isFile(name)) {
    std::error_code failed;
    if (fs::exists(name, failed)) return name;  // readModel() reports a folder
    throw std::runtime_error(messages::kNoModelFile + name + "; " + listShippedModels());
  }
  for (const std::string& folder : modelFolders())
    if (const fs::path file = fs::path{folder} / (name + std::string{kExtension}); isFile(file)) return file.string();
  throw std::runtime_error(messages::kNoModel + ("\"" + name) + "\"; " + listShippedModels() +
                           "; name your own file by its path, as in ./my-robot.ini");
}

}  // namespace darwinop::twin
