// What a loop that is killed leaves to the next one.
#include "runtime/robot_notes.hpp"

#include <gtest/gtest.h>

#include "safety/fault_book.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

class Notes : public testing::Test {
 protected:
  /// The loop is seen in this state for so many cycles.
  void see(State state, int cycles = 1, Fault fault = Fault::kNone) {
    seen_.safety.state = state;
    seen_.safety.active.reset();
    if (fault != Fault::kNone) seen_.safety.active.set(safety::rowIndex(fault));
    for (int i = 0; i < cycles; ++i) {
      ++seen_.cycle;
      notes_.update(seen_);
    }
  }

  TemporaryFolder folder_;
  RuntimeFiles files_{folder_ / "runtime"};
  RobotNotes notes_{files_};
  Sensors seen_;
};

TEST_F(Notes, ARobotThatALoopHeldIsKnownToTheNextLoop) {
  EXPECT_FALSE(RobotNotes{files_}.held());
  see(State::kTakingOver);
  EXPECT_TRUE(RobotNotes{files_}.held());
}

TEST_F(Notes, ARobotFoundStiffIsHeldToo) {
  see(State::kFoundStiff);
  EXPECT_TRUE(RobotNotes{files_}.held());
}

TEST_F(Notes, ARobotCountsAsHeldUntilEachServoWasLookedAt) {
  see(State::kDriven);
  see(State::kLimp, kJoints);
  EXPECT_TRUE(RobotNotes{files_}.held()) << "a torque off may have been lost";
  see(State::kOffline, 100);
  see(State::kLimp, kJoints);
  EXPECT_TRUE(RobotNotes{files_}.held());
  see(State::kLimp, 10);
  EXPECT_FALSE(RobotNotes{files_}.held());
}

TEST_F(Notes, ServoPowerThatIsFoundOffIsAReleaseOfARobotThatWasHeld) {
  RobotNotes::noteServoPowerOff(files_);
  EXPECT_FALSE(RobotNotes{files_}.released()) << "a board that was just switched on";
  see(State::kDriven);
  RobotNotes::noteServoPowerOff(files_);
  EXPECT_TRUE(RobotNotes{files_}.released());
}

TEST_F(Notes, AReleaseIsKnownUntilItsFaultIsOver) {
  for (const Fault fault : {Fault::kReleasedByButton, Fault::kReleasedByOperator, Fault::kBoardReset}) {
    see(State::kLimp, 1, fault);
    EXPECT_TRUE(RobotNotes{files_}.released());
    see(State::kLimp);
    EXPECT_FALSE(RobotNotes{files_}.released());
  }
  see(State::kKneeling, 1, Fault::kServoOverload);
  EXPECT_FALSE(RobotNotes{files_}.released()) << "it is not limp";
}

TEST_F(Notes, APersonsActEndsBoth) {
  see(State::kDriven);
  see(State::kLimp, 1, Fault::kReleasedByButton);
  RobotNotes::forget(files_);
  EXPECT_FALSE(RobotNotes{files_}.held());
  EXPECT_FALSE(RobotNotes{files_}.released());
}

}  // namespace
}  // namespace darwinop::runtime
