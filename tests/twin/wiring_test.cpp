// The twin as loaded by a controller: from its shared library, in lockstep, with the bus and safety layer of a robot.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "connect/connect.hpp"
#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;

constexpr std::size_t kNeck = index(Joint::kNeck);

/// A controller in lockstep with a twin.
class Driven {
 public:
  explicit Driven(const std::string& setting, const std::string& record_path = "") {
    connect::ConnectRequest request;
    request.setting = setting;
    request.record_path = record_path;
    request.safety.on_exit = safety::OnExit::kLimp;  // the fastest end of session
    link_ = connect::connect(request);
  }
  /// One cycle without commands.
  void look() { EXPECT_TRUE(link_->waitForCycle(++cycle_, stop_)); }
  /// One cycle.
  void step(Commands commands) {
    commands.start_where_it_is = true;
    link_->publish(commands);
    look();
  }
  [[nodiscard]] Sensors seen() const { return link_->sensors(); }
  [[nodiscard]] double time() const { return std::chrono::duration<double>(link_->now()).count(); }

 private:
  std::unique_ptr<runtime::RobotLink> link_;
  std::uint64_t cycle_ = 0;
  std::atomic<bool> stop_{false};
};

class Twin : public ::testing::Test {
 protected:
  /// A model with the sections in `more`, defaults otherwise.
  std::string modelWith(const std::string& more) {
    const std::string xml = "darwin-op.xml";
    std::filesystem::copy_file(std::filesystem::path{DARWINOP_TWIN_MODELS} / xml, folder_ / xml,
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream{folder_ / "my.ini"} << "[model]\nname = my\n" << more;
    return "twin:" + (folder_ / "my.ini");
  }
  /// Recording of two seconds of waving, without the date.
  std::string recordingOf(const std::string& setting) {
    const std::string file = folder_ / "log.csv";
    const auto start = std::chrono::steady_clock::now();
    {
      Driven robot{setting, file};
      for (int i = 0; robot.time() < 2; ++i) {
        Commands wave;
        wave.joint[kNeck].setGoal(Rad{0.5 * std::sin(0.1 * i)});
        wave.joint[index(Joint::kShoulderL)].setGoal(Rad{0.5 + 0.5 * std::sin(0.07 * i)});
        robot.step(wave);
      }
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::cout << "2 s took " << taken.count() << " s\n";
    std::string text, line;
    for (std::ifstream lines{file}; std::getline(lines, line);)
      if (!line.starts_with("# date:")) text += line + "\n";
    return text;
  }

  const TemporaryFolder folder_;
};

TEST_F(Twin, RecordingsOfEqualLockstepRunsDifferInTheDateOnly) {
  const std::string first = recordingOf("twin"), second = recordingOf("twin");
  EXPECT_THAT(first, HasSubstr("# model: twin in memory"));
  EXPECT_GT(std::ranges::count(first, '\n'), 120);  // one row per cycle
  EXPECT_TRUE(first == second);                     // not EXPECT_EQ, which would print both
}

TEST_F(Twin, NoiseComesFromTheSeed) {
  const std::string noisy = modelWith("[imu]\ngyro_noise = 0.2 rad/s\n");
  const std::string first = recordingOf(noisy), again = recordingOf(noisy);
  setenv("DARWINOP_TWIN_SEED", "2", 1);
  const std::string other = recordingOf(noisy);
  unsetenv("DARWINOP_TWIN_SEED");
  EXPECT_TRUE(first == again);
  EXPECT_FALSE(first == other);
}

TEST_F(Twin, StaysInTheStartPoseWithoutCommands) {
  Driven robot{"twin"};
  while (robot.time() < 5) robot.look();
  const Sensors seen = robot.seen();
  EXPECT_EQ(seen.safety.state, State::kLimp);
  EXPECT_FALSE(seen.safety.active.any());
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!isLeg(static_cast<Joint>(i))) continue;
    // Soles and gears settle by less than 0.05 rad; the check of the start pose allows 20 deg.
    EXPECT_NEAR(seen.joint[i].position.value, radFromTicks(kJointTable[i].start).value, 0.1) << kJointTable[i].name;
  }
  const auto& accel = seen.board.accelerometer;
  EXPECT_NEAR(std::atan2(std::hypot(accel[0].value, accel[1].value), accel[2].value), 0.2, 0.15) << "rad of tilt";
}

TEST_F(Twin, AStuckJointOverloadsItsServoAndTheSafetyLayerReportsIt) {
  // A gear that holds with 0.3 N m and a motor that gives 0.2.
  Driven robot{
      modelWith("[effect coulomb Neck]\nfriction = 0.3 N m\n[effect torque_limit Neck]\nduty = 1\n"
                "torque = 0.2 N m\n")};
  Commands push;
  push.joint[kNeck].setGoal(Rad{1.0});
  bool bit = false;
  double reported = 0;
  while (robot.time() < 8 && reported == 0) {
    robot.step(push);
    const Sensors seen = robot.seen();
    bit = bit || (seen.joint[kNeck].error_bits & error_bit::kOverload) != 0;
    if (seen.safety.worst == Fault::kServoOverload) reported = robot.time();
  }
  EXPECT_TRUE(bit);
  EXPECT_EQ(robot.seen().safety.worst, Fault::kServoOverload);
  EXPECT_EQ(robot.seen().safety.worst_joint, row(Joint::kNeck).id);
  EXPECT_EQ(robot.seen().safety.state, State::kKneeling);
  // Not before the servo's 2 s under load, nor long after: taking over takes less than 1.5 s, the goal moves 0.2 rad
  // in less than 0.1 s, and two replies confirm the bit.
  EXPECT_GT(reported, 2.0);
  EXPECT_LT(reported, 4.0);
}

TEST_F(Twin, AnUnknownModelIsRefusedWithTheListOfModels) {
  try {
    Driven robot{"twin:darwin"};
    ADD_FAILURE() << "a model that does not exist was loaded";
  } catch (const std::runtime_error& wrong) {
    EXPECT_THAT(wrong.what(), HasSubstr("darwin-op"));
    EXPECT_THAT(wrong.what(), HasSubstr("webots-2013"));
  }
}

}  // namespace
}  // namespace darwinop
