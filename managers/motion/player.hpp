// Plays pages: one call per 8 ms, and where the twenty joints are to be then.
#pragma once

#include <array>
#include <cstdint>

#include "managers/motion/joint_track.hpp"
#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

inline constexpr int kTickMs = 8;

/// By joint, 0 to 4095.
using Pose = std::array<int, kJoints>;

/// Equal to the vendor's engine tick for tick in every page of the vendor's file. It allocates nothing.
///
/// A step of n ticks takes n + 3 calls, its pause of m another m + 1: between two sections lies a call that only
/// computes, during which the joints keep their goals.
class Player {
 public:
  /// `pages` are as decodePages() gave them, and outlive the player.
  explicit Player(const PageFile& pages) : pages_{&pages} {}

  /// Begins at the pose the robot has. False, and nothing changes: a page is being played, or this one cannot be.
  bool start(int page, const Pose& present) noexcept;
  /// The next 8 ms. False: there is nothing to play, or the last page has just ended, and the pose is what it was.
  bool tick() noexcept;
  /// Ends with the page being played, after its repetition under way; then its exit page is played, if it has one.
  void requestStop() noexcept { stopping_ = true; }
  /// Ends here and now.
  void brake() noexcept { playing_ = false; }

  [[nodiscard]] bool isPlaying() const noexcept { return playing_; }
  [[nodiscard]] int page() const noexcept { return page_; }
  /// From 0.
  [[nodiscard]] int step() const noexcept { return step_; }
  [[nodiscard]] const Pose& pose() const noexcept { return pose_; }
  /// Register 28 of the joint's servo, as the page wants it.
  [[nodiscard]] int pGainRegister(Joint joint) const noexcept;

 private:
  enum class Section : std::uint8_t { kSpeedUp, kMain, kSlowDown, kPause };

  [[nodiscard]] const Page& current() const { return (*pages_)[static_cast<std::size_t>(page_)]; }
  void move() noexcept;
  bool beginNextSection() noexcept;
  bool beginNextStep() noexcept;
  void prepareStep() noexcept;
  [[nodiscard]] int chooseFollower() const noexcept;
  [[nodiscard]] StepTimes timesOf(const Step& step, const Pose& target) const noexcept;
  void beginSection(Section section, int length) noexcept;

  const PageFile* pages_;
  std::array<JointTrack, kJoints> track_{};
  Pose pose_{};
  StepTimes times_;
  Section section_ = Section::kSpeedUp;
  int page_ = 0, step_ = 0;
  int follower_ = 0;         // page after this one; 0: none. Chosen when its last step begins
  int repeats_ = 0;          // of this page, the one under way included
  int at_ = 0, length_ = 0;  // ticks of the section
  int pause_ = 0;            // ticks, after this step
  bool playing_ = false, stopping_ = false;
  bool fresh_ = false;  // started, and not a single tick since
};

}  // namespace darwinop::motion
