// The homes of the exchange: private memory, or a file that processes map.
#include "runtime/exchange.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

#include "runtime/groups.hpp"

namespace darwinop::runtime {
namespace {

[[noreturn]] void fail(const std::string& what, int error, const std::string& remedy) {
  throw std::runtime_error(what + ": " + std::strerror(error) + (remedy.empty() ? "" : "; " + remedy));
}

struct File {
  int fd;
  ~File() {
    if (fd >= 0) close(fd);
  }
};

void* map(int fd, const std::string& path, int protection = PROT_READ | PROT_WRITE) {
  void* memory = mmap(nullptr, sizeof(ExchangeBlock), protection, MAP_SHARED, fd, 0);
  if (memory == MAP_FAILED) fail("cannot map " + path, errno, "");
  return memory;
}

/// The file is another user's.
std::string notPermitted(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "cannot open " + path + ": its folder may not be read";
  return "a runtime of another user runs (" + path +
         ") and you are not permitted to use it: only its user and group '" + groupName(status.st_gid) +
         "' are. Become a member of a group of your own choice, have the runtime started with --group GROUP, "
         "and log in again. If that runtime has ended, remove what is left of it: sudo rm " +
         path;
}

void unmap(ExchangeBlock* block) {
  munmap(block, sizeof(ExchangeBlock));
}
void destroy(ExchangeBlock* block) {
  delete block;
}

}  // namespace

Exchange Exchange::inMemory() {
  return Exchange{Home{new ExchangeBlock{}, destroy}};
}

Exchange Exchange::embedded() {
  const char* path = std::getenv("DARWINOP_EXCHANGE");
  return path == nullptr || *path == '\0' ? inMemory() : create(path);
}

Exchange Exchange::create(const std::string& path, gid_t group) {
  // Made beside it and renamed: nobody ever sees half a block, and whoever still maps an old one keeps it.
  const std::string fresh = path + ".new." + std::to_string(getpid());
  unlink(fresh.c_str());
  const File file{open(fresh.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0660)};
  if (file.fd < 0) fail("cannot create " + fresh, errno, "is the folder there and yours to write?");
  try {
    if (fchmod(file.fd, 0660) != 0 || fchown(file.fd, static_cast<uid_t>(-1), group) != 0)
      fail("cannot give " + fresh + " to the group", errno, "choose a group that you are a member of");
    // Takes the pages now: a full disk is an error here and not a SIGBUS in the loop.
    if (const int error = posix_fallocate(file.fd, 0, sizeof(ExchangeBlock)); error != 0)
      fail("cannot get " + std::to_string(sizeof(ExchangeBlock)) + " bytes for " + fresh, error, "free some space");
    auto* block = new (map(file.fd, fresh)) ExchangeBlock{};
    Home home{block, unmap};
    if (rename(fresh.c_str(), path.c_str()) != 0)
      fail("cannot replace " + path, errno, "it may belong to another user: remove it, or choose another name");
    return Exchange{std::move(home)};
  } catch (...) {
    unlink(fresh.c_str());
    throw;
  }
}

Exchange Exchange::attach(const std::string& path, Access access) {
  const bool use = access == Access::kUse;
  const File file{open(path.c_str(), (use ? O_RDWR : O_RDONLY) | O_CLOEXEC | O_NOFOLLOW)};
  if (file.fd < 0 && errno == ENOENT)
    throw std::runtime_error("no runtime has been started here (" + path +
                             " does not exist); start one with: darwinop runtime");
  if (file.fd < 0 && errno == EACCES) throw std::runtime_error(notPermitted(path));
  if (file.fd < 0) fail("cannot open " + path, errno, "");
  struct stat status {};
  if (fstat(file.fd, &status) != 0) fail("cannot look at " + path, errno, "");
  // The size is looked at before mapping, the rest after: a file that is too short would kill its reader.
  bool ours = status.st_size == static_cast<off_t>(sizeof(ExchangeBlock));
  if (ours) {
    Home home{static_cast<ExchangeBlock*>(map(file.fd, path, use ? PROT_READ | PROT_WRITE : PROT_READ)), unmap};
    ours = home->magic == ExchangeBlock::kMagic && home->layout == ExchangeBlock::kLayout &&
           home->size == sizeof(ExchangeBlock);
    if (ours) return Exchange{std::move(home)};
  }
  throw std::runtime_error(path +
                           " was made by another version of the runtime; build controller and runtime from "
                           "the same version, then restart the runtime");
}

void setText(char* to, std::size_t size, const std::string& text) {
  const std::size_t count = std::min(size - 1, text.size());
  std::copy_n(text.data(), count, to);
  to[count] = '\0';
}

}  // namespace darwinop::runtime
