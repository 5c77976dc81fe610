// Creates and removes the temporary folder of a window.
#include "window/private_folder.hpp"

#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace darwinop::window {
namespace {

constexpr const char* kPrefix = "darwinop-window-";  // then the pid and the suffix of mkdtemp()

/// Created by a process of this user that no longer exists.
bool isLeft(const std::filesystem::path& path) {
  const std::string name = path.filename();
  if (!name.starts_with(kPrefix)) return false;
  char* end = nullptr;
  const long pid = std::strtol(name.c_str() + std::strlen(kPrefix), &end, 10);
  struct stat about {};
  return pid > 0 && *end == '-' && kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH &&
         lstat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode) && about.st_uid == geteuid();
}

void sweep(const std::string& parent) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{parent, ignored})
    if (isLeft(entry.path())) std::filesystem::remove_all(entry.path(), ignored);
}

}  // namespace

PrivateFolder::PrivateFolder(const std::string& parent)
    : path_{parent + "/" + kPrefix + std::to_string(getpid()) + "-XXXXXX"} {
  sweep(parent);
  if (mkdtemp(path_.data()) == nullptr)
    throw std::runtime_error("cannot create folder " + path_ + ": " + std::strerror(errno));
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace darwinop::window
