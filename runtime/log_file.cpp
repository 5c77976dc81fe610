// Buffered output file of a recording; also a pipe.
#include "runtime/log_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace darwinop::runtime {
namespace {

constexpr std::size_t kBufferBytes = 65536;
constexpr mode_t kMode = 0666;  // as fopen(); the umask applies

/// A FIFO is opened when it has a reader; a signal may interrupt that.
int openForWriting(const std::string& path) {
  int fd = -1;
  do fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
  while (fd < 0 && errno == EINTR);
  if (fd < 0) throw std::system_error{errno, std::generic_category(), path};
  return fd;
}

}  // namespace

LogFile::LogFile(const std::string& path) : fd_{openForWriting(path)} {
  buffer_.reserve(2 * kBufferBytes);
}

LogFile::~LogFile() {
  if (fd_ >= 0) ::close(fd_);
}

int LogFile::put(std::string_view text) {
  buffer_ += text;
  return buffer_.size() < kBufferBytes ? 0 : flush();
}

int LogFile::flush() {
  int error = 0;
  for (std::string_view rest = buffer_; !rest.empty() && error == 0;) {
    const ssize_t count = ::write(fd_, rest.data(), rest.size());
    if (count >= 0)
      rest.remove_prefix(static_cast<std::size_t>(count));
    else if (errno != EINTR)
      error = errno;
  }
  buffer_.clear();
  return error;
}

int LogFile::close() {
  const int error = flush();
  // After EINTR the descriptor is closed (close(2) of Linux).
  const int at_close = ::close(std::exchange(fd_, -1)) == 0 || errno == EINTR ? 0 : errno;
  return error != 0 ? error : at_close;
}

}  // namespace darwinop::runtime
