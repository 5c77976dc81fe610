// Keeps log files small: at 1 MB what is in one becomes FILE.1, and it begins anew.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace darwinop::supervisor {

/// The flash of a DARwIn-OP has 3.6 GB and a limited number of writes.
inline constexpr std::int64_t kLogBytes = 1'000'000;

/// Programs keep their log open and append to it, so it is copied and emptied, not renamed. A line written meanwhile
/// may be lost. A file that is not there, or too small, is left alone. False: it is too large and cannot be copied;
/// then it is emptied all the same, since a full disk is worse than a lost log.
bool bound(const std::string& path, std::int64_t bytes = kLogBytes);

/// Looks at the files twice a second, in an ordinary thread of its own: a disk can keep a writer waiting for seconds,
/// and the thread that watches the loop must not wait.
class LogKeeper {
 public:
  explicit LogKeeper(std::vector<std::string> paths);
  ~LogKeeper();
  LogKeeper(const LogKeeper&) = delete;
  LogKeeper& operator=(const LogKeeper&) = delete;

 private:
  std::vector<std::string> paths_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::supervisor
