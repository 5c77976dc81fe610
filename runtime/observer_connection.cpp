#include "runtime/observer_connection.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace darwinop::runtime {
namespace {

constexpr const char* kRunFolder = "/dev/shm/darwinop-run-";  // then pid, "-" and six random characters

void removeRunFolder(const std::string& path) {
  std::error_code not_permitted;
  std::filesystem::remove_all(path, not_permitted);
}

bool hasEnded(long pid) {
  return pid > 0 && kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH;
}

void removeRunFoldersOfTheDead() {
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator{"/dev/shm", unreadable}) {
    const std::string path = entry.path();
    struct stat status {};
    if (!path.starts_with(kRunFolder) || lstat(path.c_str(), &status) != 0 || status.st_uid != geteuid()) continue;
    if (hasEnded(std::strtol(path.c_str() + std::strlen(kRunFolder), nullptr, 10))) removeRunFolder(path);
  }
}

}  // namespace

ObserverConnection::ObserverConnection() : folder_{kRunFolder + std::to_string(getpid()) + "-XXXXXX"} {
  removeRunFoldersOfTheDead();
  if (mkdtemp(folder_.data()) == nullptr) folder_.clear();
}

ObserverConnection::~ObserverConnection() {
  if (!folder_.empty()) removeRunFolder(folder_);
}

}  // namespace darwinop::runtime
