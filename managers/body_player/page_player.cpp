// Plays motion pages in SI units, with a lead-in if a page's first step is too far away.
#include "managers/body_player/page_player.hpp"

#include "core/conversions.hpp"
#include "managers/motion/first_step.hpp"

namespace darwinop::body_player {

namespace {

motion::Pose inTicks(const Pose& pose) {
  motion::Pose ticks{};
  for (std::size_t i = 0; i < kJoints; ++i) ticks[i] = ticksFromRad(Rad{pose[i]});
  return ticks;
}

Pose inRad(const motion::Pose& ticks) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = radFromTicks(ticks[i]).value;
  return pose;
}

}  // namespace

bool PagePlayer::start(int page, const Pose& from) {
  const motion::Pose here = inTicks(from);
  if (!player_.start(page, here)) return false;
  carried_ms_ = 0;
  lead_in_ = {};
  const motion::Page& first = (*pages_)[static_cast<std::size_t>(page)];
  if (motion::firstStepSpeed(first, here) <= motion::kFastestFirstStep) return true;
  const motion::Pose target = motion::firstTarget(first, here);
  lead_in_ = {inRad(here), inRad(target)};
  player_.brake();
  return player_.start(page, target);
}

bool PagePlayer::advance(double ms) {
  if (!isPlaying()) return false;
  bool moved = false;
  for (carried_ms_ += ms; carried_ms_ >= motion::kTickMs && tick(); carried_ms_ -= motion::kTickMs) moved = true;
  return moved;
}

/// The next 8 ms. False if the last page has ended.
bool PagePlayer::tick() {
  if (lead_in_.done()) return player_.tick();
  lead_in_.advance(motion::kTickMs);
  return true;
}

void PagePlayer::brake() {
  player_.brake();
  lead_in_ = {};
}

double PagePlayer::goal(Joint joint) const {
  return lead_in_.done() ? radFromTicks(player_.pose()[index(joint)]).value : lead_in_.at(index(joint));
}

double PagePlayer::pGain(Joint joint) const {
  return player_.pGainRegister(joint) / kRegisterPerKp;
}

}  // namespace darwinop::body_player
