// Log rotation: at 1 MB the content moves to FILE.1 and the log starts empty.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace darwinop::supervisor {

/// The flash of a DARwIn-OP has 3.6 GB and limited write endurance.
inline constexpr std::int64_t kLogBytes = 1'000'000;

/// Programs keep their log open in append mode, so it is copied and truncated, not renamed. A line written meanwhile
/// may be lost. Missing or small files are left unchanged. Returns false if the copy failed; the file is truncated
/// anyway, since a full disk is worse than a lost log.
bool bound(const std::string& path, std::int64_t bytes = kLogBytes);

/// Checks the files twice a second in a thread without real-time priority: a disk may block a writer for seconds, and
/// the thread that monitors the loop must not block.
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
