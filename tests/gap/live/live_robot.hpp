// A robot for the live comparison: a twin in a stand, behind bus and safety layer, in lockstep. Its elbow and shoulder
// move.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "connect/connect.hpp"
#include "core/conversions.hpp"
#include "core/servo_limits.hpp"
#include "gap/live/live_comparison.hpp"
#include "hal/text_file.hpp"
#include "runtime/environment.hpp"
#include "support/temporary_folder.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap::live::test {

constexpr std::size_t kElbow = index(Joint::kArmLowerR), kShoulder = index(Joint::kShoulderR),
                      kNeck = index(Joint::kNeck);
constexpr double kPeriod = 0.016;  // s

/// The text of the shipped model with more sections, or with more keys of its [imu].
inline std::string modelText(const std::string& more) {
  const std::string shipped = readTextFile(twin::findModel("darwin-op")).value(), imu = "[imu]\n";
  if (!more.starts_with(imu)) return shipped + '\n' + more;
  const std::size_t at = shipped.find(imu);
  return shipped.substr(0, at) + more + shipped.substr(at + imu.size());
}

inline twin::Model modelWith(const std::string& more) {
  return twin::parseModel(modelText(more), twin::findModel("darwin-op"));
}

class LiveRobot {
 public:
  /// `more`: sections that its model has beside the shipped one. `clamp`: DARWINOP_TWIN_CLAMP; empty: on the floor.
  explicit LiveRobot(const std::string& more = "", const std::string& clamp = "0 1 0") {
    std::optional<runtime::Environment> stand;
    if (!clamp.empty()) stand.emplace("DARWINOP_TWIN_CLAMP", clamp);
    std::ofstream{folder_ / "robot.ini"} << modelText(more);
    connect::ConnectRequest request;
    request.setting = "twin:" + (folder_ / "robot.ini");
    request.safety.on_exit = safety::OnExit::kLimp;
    link_ = connect::connect(request);
  }

  /// One cycle. The joints in `limp` have no torque.
  LiveCycle next(const std::vector<std::size_t>& limp = {}) {
    Commands commands;
    commands.start_where_it_is = true;
    for (std::size_t i = 0; i < kJoints; ++i) commands.joint[i].setGoal(radFromTicks(kJointTable[i].start));
    for (JointCommand& joint : commands.joint) joint.setTorque(true);
    const double t = static_cast<double>(cycle_) * kPeriod;
    commands.joint[kElbow].setGoal(Rad{-0.6 + 0.4 * std::sin(3 * t)});
    commands.joint[kShoulder].setGoal(Rad{-0.6 + 0.3 * std::sin(2 * t)});
    commands.joint[kNeck].setGoal(Rad{0.3 * std::sin(2.5 * t)});
    for (const std::size_t joint : limp) commands.joint[joint].setTorque(false);
    link_->publish(commands);
    EXPECT_TRUE(link_->waitForCycle(++cycle_, stop_));
    LiveCycle out{link_->sensors(), {}};
    out.p_gain.fill(kDefaultPGain);
    return out;
  }
  /// For so many seconds.
  void runFor(double seconds, LiveComparison& comparison) {
    for (double t = 0; t < seconds; t += kPeriod) comparison.take(next());
  }

 private:
  const TemporaryFolder folder_;
  std::unique_ptr<runtime::RobotLink> link_;
  std::uint64_t cycle_ = 0;
  std::atomic<bool> stop_{false};
};

}  // namespace darwinop::gap::live::test
