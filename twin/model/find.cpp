// Finds model files: by path, or by name among the shipped ones.
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "twin/model/model.hpp"
#include "twin/model/nearest.hpp"
#include "twin/model/shelf.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".ini";

/// The running program, and the shared library that this code may lie in: a controller loads the twin from where the
/// twin is installed, not from where the controller lies.
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
      if (const fs::path shelf = above / "share/darwinop/models"; fs::is_directory(shelf, failed))
        folders.push_back(shelf.string());
  }
  return folders;
}

std::vector<std::string> shippedModels() {
  std::set<std::string> names;
  for (const std::string& folder : modelFolders()) {
    std::error_code failed;
    for (fs::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed))
      if (at->path().extension() == kEnding && isFile(at->path())) names.insert(at->path().stem().string());
  }
  return {names.begin(), names.end()};
}

std::string shippedOnes() {
  const auto names = shippedModels();
  if (names.empty()) return "no models are shipped here: let DARWINOP_MODELS name the folder that holds them";
  const std::vector<std::string_view> views(names.begin(), names.end());
  return "the shipped models are " + listed(views);
}

std::string findModel(const std::string& name) {
  const bool is_path = name.find('/') != name.npos || name.ends_with(kEnding);
  if (is_path || isFile(name)) {
    std::error_code failed;
    if (fs::exists(name, failed)) return name;  // readModel() refuses a folder
    throw std::runtime_error("there is no model file " + name + "; " + shippedOnes());
  }
  for (const std::string& folder : modelFolders())
    if (const fs::path file = fs::path{folder} / (name + std::string{kEnding}); isFile(file)) return file.string();
  throw std::runtime_error("there is no model \"" + name + "\"; " + shippedOnes() +
                           ", and a file of your own is named by its path, as in ./my-robot.ini");
}

}  // namespace darwinop::twin
