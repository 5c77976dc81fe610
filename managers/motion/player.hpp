// Plays motion pages: goals of the 20 joints, one call per 8 ms.
#pragma once

#include <array>
#include <cstdint>

#include "managers/motion/joint_track.hpp"
#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

inline constexpr int kTickMs = 8;

/// Ticks per joint, 0 to 4095.
using Pose = std::array<int, kJoints>;

/// Equal to the vendor's engine in every tick of every page of the vendor's file. Allocates nothing.
///
/// A step of n ticks takes n + 3 calls, its pause of m ticks another m + 1: between two sections one call only computes
/// and keeps the goals.
class Player {
 public:
  /// `pages`: from decodePages(); must outlive the player.
  explicit Player(const PageFile& pages) : pages_{&pages} {}

  /// Starts at the present pose. False without effect if a page is being played or this one is not playable.
  bool start(int page, const Pose& present) noexcept;
  /// The next 8 ms. False if nothing is played or the last page has just ended; the pose is then unchanged.
  bool tick() noexcept;
  /// Ends after the current repetition, then plays the exit page, if any.
  void requestStop() noexcept { stopping_ = true; }
  /// Ends immediately.
  void brake() noexcept { playing_ = false; }

  [[nodiscard]] bool isPlaying() const noexcept { return playing_; }
  [[nodiscard]] int page() const noexcept { return page_; }
  /// From 0.
  [[nodiscard]] int step() const noexcept { return step_; }
  [[nodiscard]] const Pose& pose() const noexcept { return pose_; }
  /// Register 28 of the joint's servo, from the page.
  [[nodiscard]] int pGainRegister(Joint joint) const noexcept;

 private:
  enum class Section : std::uint8_t { kSpeedUp, kMain, kSlowDown, kPause };

  [[nodiscard]] const Page& current() const { return (*pages_)[static_cast<std::size_t>(page_)]; }
  void move() noexcept;
  bool beginNextSection() noexcept;
  bool beginNextStep() noexcept;
  void prepareStep() noexcept;
  [[nodiscard]] int chooseNextPage() const noexcept;
  [[nodiscard]] StepTimes timesOf(const Step& step, const Pose& target) const noexcept;
  void beginSection(Section section, int length) noexcept;

  const PageFile* pages_;
  std::array<JointTrack, kJoints> track_{};
  Pose pose_{};
  StepTimes times_;
  Section section_ = Section::kSpeedUp;
  int page_ = 0, step_ = 0;
  int next_page_ = 0;        // 0: none. Chosen at the start of the last step
  int repeats_ = 0;          // remaining, including the current one
  int at_ = 0, length_ = 0;  // position in the section and its length, ticks
  int pause_ = 0;            // ticks, after this step
  bool playing_ = false, stopping_ = false;
  bool fresh_ = false;  // started, before the first tick
};

}  // namespace darwinop::motion
