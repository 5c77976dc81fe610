// Opens files in a folder where every user may create names, such as /dev/shm.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <optional>
#include <string>

namespace darwinop::runtime {

/// Whose file is accepted. Never one that everybody may write, never a link, a FIFO or a file with several names.
enum class FileOwner {
  kOwn,    // this user or root
  kGroup,  // also a user who shares the file with a group of this process; root accepts its own only
  kAny,    // also any user who lets this process in, when this process is root: root may look at and release any robot
};

/// An open file, closed by its destructor.
class SharedFile {
 public:
  explicit SharedFile(int fd) : fd_{fd} {}
  SharedFile(SharedFile&& other) noexcept;
  SharedFile& operator=(SharedFile&& other) noexcept;
  ~SharedFile();

  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_ = -1;
};

/// Opens without following a link, without waiting for a FIFO, and without creating. Nothing when there is no such
/// file, or when this process may not open it (see errno). Throws std::runtime_error, with owner and remedy,
/// for a file that must not be used.
std::optional<SharedFile> openShared(const std::string& path, int flags, FileOwner owner);

/// "user 'eve' (uid 1001)".
std::string ownerOf(const struct stat& status);

}  // namespace darwinop::runtime
