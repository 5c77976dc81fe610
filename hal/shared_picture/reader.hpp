// Sees what another process' camera sees.
#pragma once

#include <sys/types.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "hal/frame_source.hpp"
#include "hal/guarded_mapping.hpp"
#include "hal/shared_picture/layout.hpp"

namespace darwinop::shared_picture {

/// Asks for pictures as long as it is looked at; waits for nobody. The window may come, go and be replaced at any time;
/// what is no window of this version is not used, and `say` is told why, each thing once.
class Reader final : public FrameSource {
 public:
  struct Options {
    WindowFiles files;
    gid_t group = static_cast<gid_t>(-1);  // a window of another group is not believed; -1: any is
    std::function<Nanos()> now;            // CLOCK_MONOTONIC
    std::function<void(const std::string&)> say;
  };

  explicit Reader(Options options) : options_{std::move(options)} {}
  ~Reader() override { letGo(); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// YUYV of 320x240; `sequence` 0 before the first one. The same one again while there is none that is whole and
  /// fresh.
  CameraFrame newest() override;
  /// Only `seeing` and `frames` are known.
  [[nodiscard]] CameraHealth health() const override;

 private:
  void ask(Nanos now);
  void attach(Nanos now);
  void letGo() noexcept;
  [[nodiscard]] std::string whyNot(int file) const;
  [[nodiscard]] bool copy(const Slot& slot, Nanos now);
  void tell(const std::string& sentence);

  Options options_;
  GuardedMapping memory_;
  const Window* window_ = nullptr;
  dev_t device_ = 0;
  ino_t inode_ = 0;
  Nanos next_ask_{0}, since_{0};
  std::vector<std::uint8_t> spare_ = std::vector<std::uint8_t>(kPictureBytes), shown_ = spare_;
  CameraFrame frame_{};
  std::uint64_t frames_ = 0;
  std::set<std::string> told_;
};

}  // namespace darwinop::shared_picture
