// Plays motion pages in SI units, with a lead-in if a page's first step is too far away.
#pragma once

#include "managers/body_player/pose.hpp"
#include "managers/motion/page_file.hpp"
#include "managers/motion/player.hpp"

namespace darwinop::body_player {

class PagePlayer {
 public:
  /// `pages`: from decodePages(); must outlive the player.
  explicit PagePlayer(const motion::PageFile& pages) : pages_{&pages}, player_{pages} {}

  /// Starts at `from`, see presentPose(). If the first step is faster than the robot can move, a lead-in moves to its
  /// target and the page starts there; any other page starts immediately, as in the vendor's engine. False without
  /// effect if a page is being played or this one is not playable.
  bool start(int page, const Pose& from);
  /// Plays `ms`; less than a tick is carried over to the next call. True if the goals may have changed.
  bool advance(double ms);
  /// Ends immediately.
  void brake();

  [[nodiscard]] bool isPlaying() const { return player_.isPlaying(); }
  [[nodiscard]] int page() const { return player_.page(); }
  /// rad. After the end: the last goal.
  [[nodiscard]] double goal(Joint joint) const;
  /// Kp of the page.
  [[nodiscard]] double pGain(Joint joint) const;

 private:
  bool tick();

  const motion::PageFile* pages_;
  motion::Player player_;
  goals::LeadIn lead_in_;
  double carried_ms_ = 0;
};

}  // namespace darwinop::body_player
