// Tells the user about a camera, each thing once.
#pragma once

#include <bitset>
#include <cstddef>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "hal/camera_v4l2/trouble.hpp"

namespace darwinop::v4l2 {

/// Used by the camera's thread, but for mute().
class Voice {
 public:
  using Say = std::function<void(const std::string&)>;

  explicit Voice(Say say) : say_{std::move(say)} {}

  /// Once for each kind of trouble until back().
  void trouble(Trouble kind, const std::string& sentence);
  /// A trouble was told, and back() has not been.
  [[nodiscard]] bool troubled() const noexcept { return told_.any(); }
  /// Pictures come again; tells so if a trouble was told.
  void back(const std::string& sentence);
  /// Once for each sentence.
  void remark(const std::string& sentence);

  /// Any thread: waits for a sentence that is being said; none is said after it.
  void mute();

 private:
  void tell(const std::string& sentence);

  std::mutex mutex_;  // never held by newest() and health()
  Say say_;
  std::bitset<static_cast<std::size_t>(Trouble::kCount)> told_;
  std::set<std::string> remarks_;
};

}  // namespace darwinop::v4l2
