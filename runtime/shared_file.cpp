#include "runtime/shared_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "runtime/groups.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

bool isMemberOf(gid_t group) {
  if (getegid() == group) return true;
  std::vector<gid_t> groups(static_cast<std::size_t>(std::max(getgroups(0, nullptr), 0)));
  const int count = getgroups(static_cast<int>(groups.size()), groups.data());
  groups.resize(static_cast<std::size_t>(std::max(count, 0)));
  return std::ranges::find(groups, group) != groups.end();
}

bool accepted(const struct stat& status, FileOwner owner) {
  if (status.st_uid == geteuid() || status.st_uid == 0) return true;
  if (geteuid() == 0) return owner == FileOwner::kAny;
  return owner != FileOwner::kOwn && isMemberOf(status.st_gid);
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + " is not used: " + why + ". Remove it (sudo rm " + path +
                           "), or choose another name with --name");
}

/// Reason why the file is not accepted; empty: it is.
std::string whyRefused(const struct stat& status, FileOwner owner) {
  if (!S_ISREG(status.st_mode)) return messages::kNotARegularFile + ("; " + ownerOf(status)) + " made it";
  if (status.st_nlink > 1) return messages::kSeveralNames + ("; it belongs to " + ownerOf(status));
  if ((status.st_mode & S_IWOTH) != 0) return messages::kEveryUserMayWrite + ("; it belongs to " + ownerOf(status));
  if (!accepted(status, owner)) return "it belongs to " + ownerOf(status) + ", " + messages::kOwnerNotTrusted;
  return {};
}

}  // namespace

std::string ownerOf(const struct stat& status) {
  const std::string number = "uid " + std::to_string(status.st_uid);
  const std::optional<std::string> name = userName(status.st_uid);
  return name ? "user '" + *name + "' (" + number + ")" : "the user with " + number;
}

std::optional<Descriptor> openShared(const std::string& path, int flags, FileOwner owner) {
  Descriptor file{open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY)};
  struct stat status {};
  if (file.fd() < 0) {
    const int error = errno;
    // ELOOP: a link. ENXIO: a FIFO without a reader, or a socket. EISDIR: a folder.
    if ((error == ELOOP || error == ENXIO || error == EISDIR) && lstat(path.c_str(), &status) == 0)
      refuse(path, messages::kNotARegularFile + ("; " + ownerOf(status)) + " made it");
    if (error != ENOENT && error != EACCES)
      throw std::runtime_error("cannot open " + path + ": " + std::strerror(error));
    errno = error;
    return std::nullopt;
  }
  if (fstat(file.fd(), &status) != 0) throw std::runtime_error("cannot look at " + path + ": " + std::strerror(errno));
  if (const std::string why = whyRefused(status, owner); !why.empty()) refuse(path, why);
  return file;
}

bool removeAny(const std::string& path) {
  if (std::remove(path.c_str()) == 0 || errno == ENOENT) return true;
  std::string aside = path + ".XXXXXX";
  if (mkdtemp(aside.data()) == nullptr) return false;
  if (std::rename(path.c_str(), aside.c_str()) == 0) return true;
  rmdir(aside.c_str());
  return false;
}

}  // namespace darwinop::runtime
