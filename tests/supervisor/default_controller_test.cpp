// When the default controller may begin. Time is an argument; the controller is a script that sleeps.
#include "supervisor/default_controller.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/conversions.hpp"
#include "runtime/file_lock.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

struct Begin : ::testing::Test {
  TemporaryFolder folder;
  runtime::RuntimeFiles files{folder / "runtime"};
  DefaultController controller{folder / "", files};
  Nanos now = 100s;

  void SetUp() override {
    fs::create_directories(folder / "log");
    fs::create_directories(folder / "controllers/walk");
    const std::string program = folder / "controllers/walk/walk";
    std::ofstream{program} << "#!/bin/sh\nexec sleep 100\n";
    fs::permissions(program, fs::perms::owner_all);
    fs::create_symlink("controllers/walk", folder / "default");
  }
  static Sensors sitting(State state = State::kLimp) {
    Sensors seen;
    seen.safety.state = state;
    for (std::size_t i = 0; i < kJoints; ++i) {
      seen.joint[i].motion.received();
      seen.joint[i].position = radFromTicks(kJointTable[i].start);
    }
    seen.board.motion.received();
    seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
    return seen;
  }
  static Sensors lying() {
    Sensors seen = sitting();
    seen.board.accelerometer = {MeterPerSec2{9.80665}, MeterPerSec2{0}, MeterPerSec2{0}};
    return seen;
  }
  /// Looks every 20 ms, at least once.
  void lookFor(Nanos time, const Sensors& seen) {
    for (const Nanos end = now + time; now < end; now += 20ms) controller.look(seen, now);
  }
  [[nodiscard]] Status status() const {
    Status status;
    controller.tell(status, now);
    return status;
  }
  [[nodiscard]] bool runs() const { return status().controller_pid != 0; }
};

TEST_F(Begin, ALimpRobotHasToSitForASecond) {
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
  EXPECT_EQ(status().controller, "walk");
}

TEST_F(Begin, ARobotThatIsHeldIsNotAskedForItsPose) {
  Sensors held = lying();
  held.safety.state = State::kHolding;
  controller.look(held, now);
  EXPECT_TRUE(runs());
}

TEST_F(Begin, TheSecondCountsAnewAfterARobotThatLay) {
  lookFor(800ms, sitting());
  lookFor(20ms, lying());
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, TheSecondCountsAnewAfterABoardThatWasSilent) {
  lookFor(800ms, sitting());
  lookFor(10s, sitting(State::kOffline));
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, TheSecondCountsAnewAfterAnotherController) {
  lookFor(800ms, sitting());
  {
    const auto lease = runtime::FileLock::tryTake(files.drive_lock);
    ASSERT_TRUE(lease);
    lookFor(10s, sitting());
  }
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, WithoutADefaultNothingBegins) {
  fs::remove(folder / "default");
  lookFor(3s, sitting());
  EXPECT_FALSE(runs());
  EXPECT_EQ(status().controller, "");
  EXPECT_FALSE(status().controller_ended);
}

TEST_F(Begin, OneThatWasStoppedStaysStopped) {
  controller.stop(now);
  lookFor(3s, sitting());
  EXPECT_FALSE(runs());
  EXPECT_TRUE(status().controller_ended);
  controller.restart(now);
  lookFor(1100ms, sitting());
  EXPECT_TRUE(runs());
}

}  // namespace
}  // namespace darwinop::supervisor
