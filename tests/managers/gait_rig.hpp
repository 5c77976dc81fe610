// Test fixture: gait manager on a simulated robot.
#pragma once

#include <DARwInOPGaitManager.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <string>

#include "managers/gait/engine.hpp"
#include "support/temporary_folder.hpp"
#include "webots/fixture.hpp"

namespace darwinop::webots_api {

inline constexpr std::size_t kWalking = gait::kWalkingJoints;

class GaitManager : public Facade {
 protected:
  GaitManager() { write("[Walking Config]\nbalance_hip_roll_gain = 0\nbalance_ankle_roll_gain = 0\n"); }

  void write(const std::string& text) { std::ofstream{ini()} << text; }
  [[nodiscard]] std::string ini() const { return folder_ / "config.ini"; }

  /// In the stance, without balance: the first step is the first call of the engine.
  managers::DARwInOPGaitManager& standing() {
    for (std::size_t i = 0; i < kWalking; ++i)
      fake.image.joint[i].position = fake.image.joint[i].commanded = radFromTicks(gait::kStanding.tick[i]);
    manager().setBalanceEnable(false);
    return manager();
  }
  managers::DARwInOPGaitManager& manager() {
    if (!manager_) manager_ = std::make_unique<managers::DARwInOPGaitManager>(&robot(), ini());
    return *manager_;
  }

  int steps(int count, int ms = 16) {
    for (int i = 0; i < count; ++i) {
      manager().step(ms);
      if (robot().step(ms) == -1) return i;
    }
    return count;
  }
  std::array<int, kWalking> goals() {
    std::array<int, kWalking> ticks{};
    for (std::size_t i = 0; i < kWalking; ++i) {
      const JointCommand& command = fake.last().joint[i];
      ticks[i] = command.has(JointCommand::kGoal) ? ticksFromRad(command.goal) : -1;
    }
    return ticks;
  }
  void expectUntouched() {
    for (const JointCommand& command : fake.last().joint) EXPECT_EQ(command.set, 0);
  }
  static long lines(const std::string& text) { return std::ranges::count(text, '\n'); }

  TemporaryFolder folder_;
  std::unique_ptr<managers::DARwInOPGaitManager> manager_;
};

}  // namespace darwinop::webots_api
