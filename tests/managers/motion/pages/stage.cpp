#include "managers/motion/pages/stage.hpp"

#include <cstdio>

namespace darwinop::motion {

Watched Stage::play(const PageFile& pages, int page, double after_s) {
  Watched seen;
  Player player{pages};
  Pose present = goals_;
  for (std::size_t i = 0; i < kJoints; ++i) {  // as the motion manager begins, docs/motions.md
    constexpr int kFullPull = 256;
    const int at = ticksFromRad(Rad{body_->state().joint[i].position_rad});
    present[i] = std::clamp(present[i], at - kFullPull, at + kFullPull);
  }
  if (!player.start(page, present)) ADD_FAILURE() << "page " << page << " cannot be played";
  squares_.fill(0);
  full_for_.fill(0);
  int ticks = 0;
  for (; player.tick(); ++ticks) {
    hold(player.pose());
    for (std::size_t i = 0; i < kJoints; ++i) drives_[i].p_gain = player.pGainRegister(static_cast<Joint>(i)) / 8.0;
    body_->step(kTick, drives_);
    watchJoints(seen);
    watchContacts(seen);
    seen.lowest = std::min(seen.lowest, body_->upright());
  }
  seen.seconds = ticks * 0.008;
  seen.mean = std::sqrt(*std::ranges::max_element(squares_) / ticks);
  hold(goals_);  // the gains are the controller's again
  run(after_s);
  std::printf("page %2d: %.2f s, torque %.2f of stall at most, %.2f in the mean of the worst joint", page, seen.seconds,
              seen.peak, seen.mean);
  if (seen.full_s > 0) std::printf(", %s at full voltage for %.2f s", seen.full_joint.c_str(), seen.full_s);
  std::puts("");
  return seen;
}

void Stage::watchJoints(Watched& seen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointMotion& joint = body_->state().joint[i];
    const double torque = std::abs(joint.load - back_emf_share_ * joint.velocity_rad_s);
    seen.peak = std::max(seen.peak, torque);
    squares_[i] += torque * torque;
    full_for_[i] = std::abs(joint.load) < kFull ? 0 : full_for_[i] + 0.008;
    if (full_for_[i] > seen.full_s) {
      seen.full_s = full_for_[i];
      seen.full_joint = kJointTable[i].name;
    }
    seen.overload = seen.overload || joint.overload;
  }
}

void Stage::watchContacts(Watched& seen) {
  const mjModel& m = *body_->mujocoModel();
  const mjData& d = *body_->mujocoData();
  for (int c = 0; c < d.ncon; ++c) {
    const mjContact& contact = d.contact[c];
    const auto of_robot = [&](int geom) { return m.body_rootid[m.geom_bodyid[geom]] == map_.trunk; };
    if (contact.dist > -kTouch || !of_robot(contact.geom1) || !of_robot(contact.geom2)) continue;
    seen.touching.insert(std::string{mj_id2name(&m, mjOBJ_GEOM, contact.geom1)} + " and " +
                         mj_id2name(&m, mjOBJ_GEOM, contact.geom2));
  }
}

}  // namespace darwinop::motion
