#include "runtime/marker_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <utility>

#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

constexpr char kClear = '0', kSet = '1';

bool isGone(const Descriptor& file) {
  struct stat status {};
  return fstat(file.fd(), &status) != 0 || status.st_nlink == 0;
}

std::string makerOf(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 ? ownerOf(status) : "an unknown user";
}

}  // namespace

MarkerFile::MarkerFile(std::string path) : path_{std::move(path)} {
  find();
  if (!kept()) create();
  if (!warning_.empty()) warning_ += kept() ? messages::kMarkerReplaced : messages::kRemoveMarker + path_;
}

void MarkerFile::find() {
  std::optional<Descriptor> found;
  bool absent = false;
  try {
    found = openShared(path_, O_RDWR, FileOwner::kOwn);
    absent = !found && errno == ENOENT;
  } catch (const std::runtime_error&) {  // not a plain file, or of another user
  }
  if (!found) {
    set_ = !absent;
    if (set_) warning_ = path_ + messages::kMarkerOfOthers + makerOf(path_) + messages::kMarkerCountsAsSet;
    return;
  }
  char content = kSet;  // an empty file counts as set
  (void)!pread(found->fd(), &content, 1, 0);
  set_ = content != kClear;
  file_ = std::move(*found);
}

/// Another user may take the name again at any moment.
void MarkerFile::create() {
  for (int attempt = 0; attempt < 3; ++attempt) {
    Descriptor fresh{open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644)};
    if (fresh.fd() >= 0) {
      file_ = std::move(fresh);
      (void)write();
      return;
    }
    if (errno != EEXIST || !removeAny(path_)) return;
  }
}

void MarkerFile::set(bool wanted) {
  const bool changes = wanted != set_;
  set_ = wanted;
  if (kept() && isGone(file_)) file_ = Descriptor{-1};
  if (!kept()) return wanted ? create() : void();
  if (changes) (void)write();
}

bool MarkerFile::write() const {
  const char content[] = {set_ ? kSet : kClear, '\n'};
  return pwrite(file_.fd(), content, sizeof content, 0) == sizeof content;
}

void MarkerFile::removeIfClear() {
  if (!set_ && kept() && !isGone(file_)) unlink(path_.c_str());
}

}  // namespace darwinop::runtime
