// Log rotation.
#include "supervisor/log_keeper.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hal/descriptor.hpp"

namespace darwinop::supervisor {
namespace {

/// Copies the last `bytes`: a fast writer may have written more than can be kept.
bool copyEnd(int from, std::int64_t size, std::int64_t bytes, const std::string& to) {
  const Descriptor copy{open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644)};
  if (copy.fd() < 0) return false;
  std::array<char, 16384> part{};
  off_t at = static_cast<off_t>(std::max<std::int64_t>(0, size - bytes));
  for (std::int64_t left = std::min(size, bytes); left > 0;) {
    const auto want = static_cast<std::size_t>(std::min<std::int64_t>(left, part.size()));
    const ssize_t got = pread(from, part.data(), want, at);
    if (got <= 0 || write(copy.fd(), part.data(), static_cast<std::size_t>(got)) != got) return false;
    at += static_cast<off_t>(got);
    left -= got;
  }
  return true;
}

}  // namespace

bool bound(const std::string& path, std::int64_t bytes) {
  const Descriptor file{open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW)};
  struct stat info {};
  if (file.fd() < 0 || fstat(file.fd(), &info) != 0 || info.st_size < bytes) return true;
  const bool copied = copyEnd(file.fd(), info.st_size, bytes, path + ".1");
  return ftruncate(file.fd(), 0) == 0 && copied;
}

LogKeeper::LogKeeper(std::vector<std::string> paths)
    : paths_{std::move(paths)}, thread_{[this] {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, nullptr);  // the main thread handles signals
        while (!stop_) {
          for (const std::string& path : paths_) (void)bound(path);
          const timespec pause{0, 500'000'000};
          nanosleep(&pause, nullptr);
        }
      }} {}

LogKeeper::~LogKeeper() {
  stop_ = true;
  thread_.join();
}

}  // namespace darwinop::supervisor
