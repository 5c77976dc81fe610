#include "hal/process/start.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace darwinop::process {

namespace fs = std::filesystem;

std::string findProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* const path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "/usr/local/bin:/bin:/usr/bin" : path};
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string program = (folder.empty() ? "." : folder) + "/" + name;
    std::error_code unreadable;
    if (fs::is_regular_file(program, unreadable) && access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

std::string programBeside(const std::string& name) {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).parent_path() / name;
}

}  // namespace darwinop::process
