#include "runtime/exchange_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "runtime/groups.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

[[noreturn]] void fail(const std::string& what, int error, const std::string& remedy) {
  throw std::runtime_error(what + ": " + std::strerror(error) + (remedy.empty() ? "" : "; " + remedy));
}

/// Why the file cannot be opened: whose it is, and what to do.
std::string notPermitted(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "cannot open " + path + ": its folder may not be read";
  return messages::kOtherUsersRuntime + path + ") and you are not permitted to use it: only " + ownerOf(status) +
         " and group '" + groupName(status.st_gid) +
         "' are. Become a member of a group of your own choice, have the runtime started with --group GROUP, "
         "and log in again. If that runtime has ended, remove what is left of it: sudo rm " +
         path;
}

std::string whoHas(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return "choose another name with --name";
  return "it belongs to " + ownerOf(status) + ". Remove it (sudo rm " + path + "), or choose another name with --name";
}

}  // namespace

std::string commandsPath(const std::string& path) {
  return path + ".commands";
}

GuardedMapping mapped(const Descriptor& file, const std::string& path, std::size_t size, int protection) try {
  return GuardedMapping{file.fd(), size, protection};
} catch (const std::system_error& error) {
  fail("cannot map " + path, error.code().value(), "");
}

FreshFile::FreshFile(std::string path, mode_t mode, gid_t group, std::size_t size)
    : path_{std::move(path)}, fresh_{path_ + ".XXXXXX"}, file_{opened(fresh_)} {
  if (fchmod(file_.fd(), mode) != 0 || fchown(file_.fd(), static_cast<uid_t>(-1), group) != 0) {
    const int error = errno;
    unlink(fresh_.c_str());
    fail("cannot give " + fresh_ + " to the group", error, "choose a group that you are a member of");
  }
  // Allocates the pages now: a full disk is an error here instead of a SIGBUS in the loop.
  if (const int error = posix_fallocate(file_.fd(), 0, static_cast<off_t>(size)); error != 0) {
    unlink(fresh_.c_str());
    fail("cannot get " + std::to_string(size) + " bytes for " + fresh_, error, "free some space");
  }
}

FreshFile::~FreshFile() {
  if (!placed_) unlink(fresh_.c_str());
}

Descriptor FreshFile::place() {
  if (rename(fresh_.c_str(), path_.c_str()) != 0) fail("cannot replace " + path_, errno, whoHas(path_));
  placed_ = true;
  return std::move(file_);
}

Descriptor FreshFile::opened(std::string& fresh) {
  Descriptor file{mkostemp(fresh.data(), O_CLOEXEC)};
  if (file.fd() < 0) fail("cannot create " + fresh, errno, "is the folder there and yours to write?");
  return file;
}

bool hasSize(const Descriptor& file, std::size_t size) {
  struct stat status {};
  return fstat(file.fd(), &status) == 0 && status.st_size >= static_cast<off_t>(size);
}

uid_t userOf(const Descriptor& file) {
  struct stat status {};
  return fstat(file.fd(), &status) == 0 ? status.st_uid : static_cast<uid_t>(-1);
}

Descriptor openedBlock(const std::string& path) {
  if (auto file = openShared(path, O_RDONLY, FileOwner::kAny)) return std::move(*file);
  if (errno == EACCES) throw std::runtime_error(notPermitted(path));
  throw std::runtime_error(messages::kNoRuntime + path + " does not exist); " + messages::kStartRuntime);
}

Descriptor openedCommands(const std::string& path, uid_t user) {
  auto file = openShared(path, O_RDWR, FileOwner::kAny);
  if (!file && errno == EACCES) throw std::runtime_error(notPermitted(path));
  if (!file)
    throw std::runtime_error(messages::kTakesNoCommands + path +
                             " does not exist): a controller hosts it, or the supervisor brings the robot to rest");
  if (userOf(*file) != user)
    throw std::runtime_error(path + " is not used: " + whoHas(path) + ". The runtime is of another user");
  return std::move(*file);
}

}  // namespace darwinop::runtime
