// Sequences sections, steps and pages. Joint trajectories: joint_track.hpp.
#include "managers/motion/player.hpp"

#include <cstdlib>

namespace darwinop::motion {

namespace {

/// Target of a joint in a step; `before`: its previous target.
int targetOf(const Step& step, std::size_t joint, int before) {
  const std::uint16_t word = step.position[joint + 1];  // by servo id
  return (word & (kKeep | kTorqueOff)) != 0 ? before : std::min<int>(word, kTickMax);
}

bool continues(int start, int target, int next) {
  return (start < target && target < next) || (start > target && target > next);
}

/// Time or speed of a step, scaled by the page's speed (32: as in the file).
int scaled(const Step& step, const Page& page) {
  return std::max(1, (step.time * page.speed) >> 5);
}

}  // namespace

bool Player::start(int page, const Pose& present) noexcept {
  if (playing_ || page <= 0 || page >= static_cast<int>(kPages)) return false;
  if (!(*pages_)[static_cast<std::size_t>(page)].canPlay()) return false;
  page_ = page;
  step_ = 0;
  repeats_ = current().repeat;
  for (std::size_t i = 0; i < kJoints; ++i) {
    pose_[i] = std::clamp(present[i], 0, kTickMax);
    track_[i].rest(pose_[i]);
  }
  at_ = length_ = 0;
  stopping_ = false;
  playing_ = fresh_ = true;
  return true;
}

bool Player::tick() noexcept {
  if (!playing_) return false;
  if (at_ < length_) {
    ++at_;
    move();
  } else {
    playing_ = beginNextSection();
  }
  return playing_;
}

int Player::pGainRegister(Joint joint) const noexcept {
  return motion::pGainRegister(current().slopes[index(joint) + 1]);
}

void Player::move() noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (section_ == Section::kSpeedUp) track_[i].speedUp(at_, length_);
    if (section_ == Section::kMain) track_[i].cruise(at_, length_);
    if (section_ == Section::kSlowDown) track_[i].slowDown(at_, length_);
    pose_[i] = track_[i].output();
  }
}

void Player::beginSection(Section section, int length) noexcept {
  section_ = section;
  at_ = 0;
  length_ = length;
}

bool Player::beginNextSection() noexcept {
  if (fresh_) {
    fresh_ = false;
    prepareStep();
    return true;
  }
  for (JointTrack& track : track_) track.endSection();
  switch (section_) {
    case Section::kSpeedUp:
      for (JointTrack& track : track_) track.beginMain(times_);
      beginSection(Section::kMain, times_.main());
      return true;
    case Section::kMain:
      for (JointTrack& track : track_) track.beginSlowDown();
      beginSection(Section::kSlowDown, times_.acceleration);
      return true;
    case Section::kSlowDown:
      if (pause_ == 0) return beginNextStep();
      beginSection(Section::kPause, pause_);
      return true;
    case Section::kPause:
      for (JointTrack& track : track_) track.endPause();
      return beginNextStep();
  }
  return false;
}

bool Player::beginNextStep() noexcept {
  if (++step_ >= current().steps) {
    if (next_page_ == 0) {
      step_ = current().steps - 1;
      return false;
    }
    // A page that names itself as next restarts with all repetitions.
    repeats_ =
        next_page_ == page_ && repeats_ > 1 ? repeats_ - 1 : (*pages_)[static_cast<std::size_t>(next_page_)].repeat;
    page_ = next_page_;
    step_ = 0;
  }
  prepareStep();
  return true;
}

int Player::chooseNextPage() const noexcept {
  const Page& page = current();
  const int next = stopping_ ? page.exit : repeats_ > 1 ? page_ : page.next;
  return next != 0 && (*pages_)[static_cast<std::size_t>(next)].canPlay() ? next : 0;
}

void Player::prepareStep() noexcept {
  const Page& page = current();
  const Step& step = page.step[static_cast<std::size_t>(step_)];
  const bool last_of_page = step_ == page.steps - 1;
  if (last_of_page) next_page_ = chooseNextPage();
  const Step* following = nullptr;
  if (!last_of_page)
    following = &page.step[static_cast<std::size_t>(step_) + 1];
  else if (next_page_ != 0)
    following = (*pages_)[static_cast<std::size_t>(next_page_)].step.data();

  pause_ = (step.pause << 5) / page.speed;
  Pose target;
  for (std::size_t i = 0; i < kJoints; ++i) target[i] = targetOf(step, i, track_[i].target());
  times_ = timesOf(step, target);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const int next = following ? targetOf(*following, i, target[i]) : target[i];
    const bool ends = pause_ > 0 || !continues(track_[i].target(), target[i], next);
    track_[i].prepare(target[i], ends, times_);
  }
  beginSection(Section::kSpeedUp, times_.acceleration);
}

StepTimes Player::timesOf(const Step& step, const Pose& target) const noexcept {
  int ticks = scaled(step, current());
  if (current().schedule == kSpeedBased) {
    int farthest = 0;
    for (std::size_t i = 0; i < kJoints; ++i) farthest = std::max(farthest, std::abs(target[i] - track_[i].target()));
    ticks = 40 * farthest / (3 * ticks);
  }
  return StepTimes::fitted(ticks, current().acceleration);
}

}  // namespace darwinop::motion
