// Reports each camera message once.
#pragma once

#include <bitset>
#include <cstddef>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "hal/camera_v4l2/camera_error.hpp"

namespace darwinop::v4l2 {

/// Camera's thread only, except mute().
class Reporter {
 public:
  using Log = std::function<void(const std::string&)>;

  explicit Reporter(Log say) : log_{std::move(say)} {}

  /// Once for each kind of error until back().
  void report(CameraError kind, const std::string& sentence);
  /// An error was reported and back() has not followed.
  [[nodiscard]] bool hasError() const noexcept { return reported_.any(); }
  /// Pictures arrive again; reports this if an error was reported.
  void back(const std::string& sentence);
  /// Once for each text.
  void remark(const std::string& sentence);

  /// Any thread: waits for a message in progress; no message follows.
  void mute();

 private:
  void send(const std::string& sentence);

  std::mutex mutex_;  // never locked by newest() or health()
  Log log_;
  std::bitset<static_cast<std::size_t>(CameraError::kCount)> reported_;
  std::set<std::string> remarks_;
};

}  // namespace darwinop::v4l2
