// Reads the camera pictures published by another process.
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

// Phrases by which the messages of Reader are recognized.
inline constexpr const char* kNoNewPictures = "no new pictures in ";
inline constexpr const char* kNotAPlainFile = "not a regular file with one name that only its group may write";
inline constexpr const char* kOtherVersion = "written by another version";

/// Requests pictures while newest() is called; never blocks. The file may be created, removed and replaced at any time;
/// files of other versions are ignored. `log` receives each message once.
class Reader final : public FrameSource {
 public:
  struct Options {
    WindowFiles files;
    gid_t group = static_cast<gid_t>(-1);  // required group of the file; -1: any
    std::function<Nanos()> now;            // CLOCK_MONOTONIC
    std::function<void(const std::string&)> log;
  };

  explicit Reader(Options options) : options_{std::move(options)} {}
  ~Reader() override { unmap(); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// YUYV of 320x240; `sequence` 0 before the first one. The previous picture while there is no newer complete one.
  CameraFrame newest() override;
  /// Only `seeing` and `frames` are set.
  [[nodiscard]] CameraHealth health() const override;

 private:
  void ask(Nanos now);
  void attach(Nanos now);
  void unmap() noexcept;
  [[nodiscard]] std::string rejection(int file) const;
  [[nodiscard]] bool copy(const Slot& slot, Nanos now);
  void log(const std::string& sentence);

  Options options_;
  GuardedMapping memory_;
  const SharedWindow* window_ = nullptr;
  dev_t device_ = 0;
  ino_t inode_ = 0;
  Nanos next_ask_{0}, since_{0};
  std::vector<std::uint8_t> spare_ = std::vector<std::uint8_t>(kPictureBytes), shown_ = spare_;
  CameraFrame frame_{};
  std::uint64_t frames_ = 0;
  std::set<std::string> logged_;
};

}  // namespace darwinop::shared_picture
