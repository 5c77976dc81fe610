// Buffered output file of a recording; also a pipe.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::runtime {

/// Signals do not end a write: a pipe whose reader is slow interrupts a write() at Ctrl-C (EINTR), and the rest must
/// still be written. Not thread-safe; SIGPIPE must be ignored (hal/signals.hpp).
class LogFile {
 public:
  /// Opens and truncates. Throws std::system_error.
  explicit LogFile(const std::string& path);
  /// Closes without writing the buffer.
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// Writes to the buffer, and the buffer to the file when it is full. All return 0 or errno; what could not be written
  /// is discarded.
  [[nodiscard]] int put(std::string_view text);
  [[nodiscard]] int flush();
  /// flush(), and closes: some file systems report a full disk only now.
  [[nodiscard]] int close();

 private:
  int fd_;
  std::string buffer_;
};

}  // namespace darwinop::runtime
