// Reads every frame that goes out and holds it against the promises of the safety layer.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "campaign/leniencies.hpp"
#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/packet.hpp"
#include "core/registers.hpp"
#include "core/sensors.hpp"
#include "hil-mocks/memory_line.hpp"

namespace darwinop {

class WireJudge final : public hil::WireObserver {
 public:
  WireJudge(hil::VirtualRobot& robot, Nanos period, double max_joint_speed)
      : robot_{robot},
        max_step_{max_joint_speed * std::chrono::duration<double>(period).count() / kRadPerTick +
                  bound(Leniency::kRounding)} {}

  void beginCycle() {
    // Two devices with one id answer at once; what is left of it can be a wrong position with a right checksum.
    for (std::size_t i = 0; i < kJoints; ++i)
      if (robot_.board().hasTwin(static_cast<Joint>(i))) twin_seen_[i] = cycle_;
    ++cycle_;
    sync_writes_ = bulk_reads_ = 0;
    const bool was_out = cable_out_;
    limited_.reset();
    given_.reset();
    torque_ = false;
    cable_out_ = !robot_.portOpen();
    blind_ = was_out || cable_out_ || replugs_ != robot_.replugs();
    replugs_ = robot_.replugs();
  }
  /// A joint that is not driven starts again with its next goal.
  void endCycle(const Sensors& seen) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (!seen.joint[joint].driven) goal_[joint].reset();
    // A goal that went into a cable that was out is a step nobody saw. At most one is on the way: the next goal
    // waits for an answer.
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (limited_[joint] && !given_[joint]) ++waited_[joint];
    const bool lost = sync_writes_ == 0 && (cable_out_ || !robot_.portOpen() || robot_.replugs() != replugs_);
    if (lost) step_unseen_.set();
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (seen.joint[joint].motion.fresh())
        strains_[joint] = std::abs(seen.joint[joint].load) * kTorqueMax >=
                          bound(Leniency::kSecondSyncWrite) * std::min(limit_[joint], limit_before_[joint]);
  }
  void request(const Frame& frame, Nanos at) noexcept override {
    (void)at;
    if (frame.code == static_cast<std::uint8_t>(Instruction::kBulkRead) && ++bulk_reads_ > 1) blame("two BulkReads");
    if (frame.code != static_cast<std::uint8_t>(Instruction::kSyncWrite)) return;
    if (++sync_writes_ > 2) blame("three SyncWrites");
    if (sync_writes_ == 2) {
      tolerated_.note(Leniency::kSecondSyncWrite);
      if (strains_.none() && !blind_) blame("two SyncWrites, and no servo works at its torque limit");
    }
    judgeSyncWrite(frame.params);
  }
  void reply(Bytes bytes, Nanos at) noexcept override { (void)bytes, (void)at; }

  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] const Tolerated& tolerated() const { return tolerated_; }
  [[nodiscard]] long goalsSeen() const { return goals_; }

 private:
  void judgeSyncWrite(Bytes params) {
    const std::uint8_t address = params[0], length = params[1];
    if (address == servo::kLock) return;
    torque_ = address == servo::kTorqueEnable;
    const bool limits = address == servo::kTorqueLimit && length == 2;
    if (!torque_ && !limits && (address > servo::kGoalPosition || address + length < servo::kGoalPosition + 2))
      return blame("registers nobody asked for: " + std::to_string(address));
    for (std::size_t at = 2; at + length < params.size(); at += length + 1U) {
      const std::size_t joint = params[at] - 1U;
      if (joint >= kJoints) return blame("a servo that does not exist");
      if (limits) {
        noteLimit(joint, wordAt(params, at + 1));
        limited_.set(joint);
        continue;
      }
      if (torque_) {
        if (params[at + 1] == 0) goal_[joint].reset();
        continue;
      }
      if (address + length >= servo::kTorqueLimit + 2)
        noteLimit(joint, wordAt(params, at + 1 + (servo::kTorqueLimit - address)));
      const std::size_t goal_at = at + 1 + (servo::kGoalPosition - address);
      judgeGoal(joint, wordAt(params, goal_at));
    }
  }

  /// The servo has this one or, when the frame is lost, the one before.
  void noteLimit(std::size_t joint, int limit) {
    limit_before_[joint] = limit_[joint];
    limit_[joint] = limit;
  }

  void judgeGoal(std::size_t joint, int ticks) {
    ++goals_;
    const JointRow& r = kJointTable[joint];
    if (ticks < r.low || ticks > r.high) blame(std::string{r.name} + " goal out of limits: " + std::to_string(ticks));
    if (given_[joint]) blame(std::string{r.name} + " got two goals in one cycle");
    const int unseen = step_unseen_[joint] ? boundAs<int>(Leniency::kGoalInCable) : 0;
    const int waited = waited_[joint] * boundAs<int>(Leniency::kGoalAfterLimit);
    const int step = goal_[joint] ? std::abs(ticks - *goal_[joint]) : 0;
    if (step > max_step_ && unseen > 0) tolerated_.note(Leniency::kGoalInCable);
    if (step > max_step_ && waited > 0) tolerated_.note(Leniency::kGoalAfterLimit);
    if (step > max_step_ * (1 + unseen + waited))
      blame(std::string{r.name} + " jumped " + std::to_string(ticks - *goal_[joint]) + " ticks");
    if (!goal_[joint] && cycle_ - twin_seen_[joint] > boundAs<long>(Leniency::kUntrusted)) judgeFirst(joint, ticks);
    goal_[joint] = ticks;
    step_unseen_.reset(joint);
    waited_[joint] = 0;
    given_.set(joint);
  }

  /// A joint that was not driven starts from where it is (or from its limit, when it hangs outside).
  void judgeFirst(std::size_t joint, int ticks) {
    const double truth = robot_.body().state().joint[joint].position_rad / kRadPerTick + kTickCentre;
    const double expected = std::clamp<double>(truth, kJointTable[joint].low, kJointTable[joint].high);
    if (std::abs(ticks - expected) > bound(Leniency::kNearJoint)) tolerated_.note(Leniency::kFirstGoal);
    if (std::abs(ticks - expected) > bound(Leniency::kFirstGoal))
      blame(std::string{kJointTable[joint].name} + " taken over " + std::to_string(ticks - expected) + " ticks off");
  }

  void blame(const std::string& what) {
    if (failure_.empty()) failure_ = "cycle " + std::to_string(cycle_) + ": " + what;
  }

  hil::VirtualRobot& robot_;
  double max_step_;
  std::array<std::optional<int>, kJoints> goal_{};
  std::array<long, kJoints> twin_seen_ = [] {
    std::array<long, kJoints> never{};
    never.fill(-1000);
    return never;
  }();
  long cycle_ = 0;
  bool torque_ = false;
  int sync_writes_ = 0, bulk_reads_ = 0;
  std::bitset<kJoints> step_unseen_, limited_, given_;
  std::array<int, kJoints> waited_{};                  // cycles without a goal, for a limit, since the last goal
  std::array<int, kJoints> limit_{}, limit_before_{};  // torque limits sent
  std::bitset<kJoints> strains_;                       // works at its torque limit, by what the PC reads
  bool cable_out_ = false, blind_ = false;             // blind: a frame may have been lost in the cable
  Tolerated tolerated_;
  std::uint32_t replugs_ = 0;
  long goals_ = 0;
  std::string failure_;
};

}  // namespace darwinop
