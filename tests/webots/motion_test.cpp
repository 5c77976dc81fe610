// The .motion player as controllers use it: when it moves motors, where to, and what it says of bad files.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <fstream>
#include <webots/Motor.hpp>
#include <webots/utils/Motion.hpp>

#include "core/goals/lead_in.hpp"
#include "fixture.hpp"
#include "hal/text_file.hpp"
#include "support/temporary_folder.hpp"
#include "webots/messages.hpp"
#include "webots/motion_text.hpp"

namespace darwinop::webots_api {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

/// Two motors over 64 ms: the neck goes to 0.4 rad and back, the head gets a value in the middle only.
constexpr const char* kNod =
    "#WEBOTS_MOTION,V1.0,Neck,Head\n"
    "00:00:000,Rest,0,*\n"
    "00:00:032,Up,0.4,0.1\n"
    "00:00:064,Rest,0,*\n";

class MotionTest : public Facade {
 protected:
  std::string file(const std::string& text, const std::string& name = "test.motion") {
    std::ofstream{folder_ / name} << text;
    return folder_ / name;
  }
  /// The robot has its neck there, so that a motion that begins near it begins at once.
  void neckIsAt(double rad) {
    JointSensors& neck = fake.image.joint[index(Joint::kNeck)];
    neck.commanded = neck.position = Rad{rad};
    robot().step(16);
  }
  /// As a robot does it: what was asked for is where the joints are in the next cycle.
  void jointsFollow() {
    fake.on_cycle = [this](std::uint64_t) {
      for (std::size_t i = 0; i < kJoints; ++i) {
        const JointCommand& asked = fake.last().joint[i];
        JointSensors& joint = fake.image.joint[i];
        if (asked.has(JointCommand::kGoal)) joint.commanded = joint.position = asked.goal;
      }
    };
  }
  /// The goal in the next step; NaN: none was ever set.
  double neckAfterStep() { return goalOf(commanded(Joint::kNeck)); }
  double headOfLastStep() { return goalOf(fake.last().joint[index(Joint::kHead)]); }
  std::vector<double> necks(int steps) {
    std::vector<double> seen(static_cast<std::size_t>(steps));
    for (double& goal : seen) goal = std::round(neckAfterStep() * 1000) / 1000;
    return seen;
  }
  /// Messages about a file with this text.
  std::string sentenceAbout(const std::string& text) {
    CaptureStderr();
    const webots::Motion motion{file(text)};
    std::string said = GetCapturedStderr();
    EXPECT_EQ(motion.isValid(), said.empty());
    EXPECT_EQ(motion.isOver(), motion.getDuration() == 0);
    const std::string path = folder_ / "";
    if (const auto at = said.find(path); at != std::string::npos) said.erase(at, path.size());
    return said;
  }

 private:
  static double goalOf(const JointCommand& command) {
    return command.has(JointCommand::kGoal) ? command.goal.value : kUnknown;
  }
  TemporaryFolder folder_;
};

TEST_F(MotionTest, ItMovesMotorsFromPlayToItsEndAndAtNoOtherTime) {
  webots::Motion motion{file(kNod)};
  ASSERT_TRUE(motion.isValid());
  EXPECT_EQ(motion.getDuration(), 64);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(commanded(Joint::kNeck).set, 0) << "made, not played";
  EXPECT_FALSE(motion.isOver());
  motion.play();
  EXPECT_THAT(necks(4), ElementsAre(0, 0.2, 0.4, 0.2));
  EXPECT_FALSE(motion.isOver());
  EXPECT_EQ(motion.getTime(), 48);
  EXPECT_THAT(necks(1), ElementsAre(0));
  EXPECT_TRUE(motion.isOver());
  robot().getMotor("Neck")->setPosition(0.7);
  EXPECT_THAT(necks(2), ElementsAre(0.7, 0.7)) << "over: the neck is the controller's";
}

TEST_F(MotionTest, AMotorIsCommandedFromItsFirstValueOnAndHoldsItsLast) {
  webots::Motion motion{file(kNod)};
  motion.play();
  neckAfterStep();
  EXPECT_TRUE(std::isnan(headOfLastStep())) << "its first value is still to come";
  neckAfterStep();
  neckAfterStep();
  EXPECT_EQ(headOfLastStep(), 0.1);
  robot().getMotor("Head")->setPosition(0.3);
  neckAfterStep();
  EXPECT_EQ(headOfLastStep(), 0.1) << "held until the end of the motion";
}

TEST_F(MotionTest, StopKeepsTheTimeAndPlayGoesOnFromIt) {
  webots::Motion motion{file(kNod)};
  motion.play();
  necks(2);
  motion.stop();
  robot().getMotor("Neck")->setPosition(0.7);
  EXPECT_THAT(necks(10), testing::Each(0.7));
  EXPECT_EQ(motion.getTime(), 16);
  neckIsAt(0.25);
  motion.play();
  EXPECT_THAT(necks(3), ElementsAre(0.2, 0.4, 0.2)) << "the pause does not count";
}

TEST_F(MotionTest, PlayedAgainItStartsAgain) {
  webots::Motion motion{file(kNod)};
  for (int round = 0; round < 2; ++round) {
    motion.play();
    EXPECT_THAT(necks(5), ElementsAre(0, 0.2, 0.4, 0.2, 0)) << round;
    EXPECT_TRUE(motion.isOver());
  }
}

TEST_F(MotionTest, AnotherPlayWhileItPlaysChangesNothing) {
  webots::Motion motion{file(kNod)};
  std::array<double, 5> seen{};
  for (double& goal : seen) {
    motion.play();
    goal = necks(1).front();
  }
  EXPECT_THAT(seen, ElementsAre(0, 0.2, 0.4, 0.2, 0));
}

TEST_F(MotionTest, LoopedItShowsItsEndOnceAndIsNeverOver) {
  webots::Motion motion{file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,0\n00:00:032,B,0.4\n")};
  motion.setLoop(true);
  motion.play();
  EXPECT_THAT(necks(7), ElementsAre(0, 0.2, 0.4, 0.2, 0.4, 0.2, 0.4));
  EXPECT_FALSE(motion.isOver());
  motion.setLoop(false);
  EXPECT_TRUE(motion.isOver());
}

TEST_F(MotionTest, ReversedItRunsToItsBeginning) {
  webots::Motion motion{file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,0\n00:00:032,B,0.4\n")};
  motion.setReverse(true);
  neckIsAt(0.4);
  motion.play();
  EXPECT_EQ(motion.getTime(), 32);
  EXPECT_THAT(necks(3), ElementsAre(0.4, 0.2, 0));
  EXPECT_TRUE(motion.isOver());
  motion.setLoop(true);
  motion.play();
  EXPECT_THAT(necks(5), ElementsAre(0.4, 0.2, 0, 0.2, 0));
  motion.setReverse(false);
  EXPECT_THAT(necks(2), ElementsAre(0.2, 0.4)) << "turned round on the way";
}

TEST_F(MotionTest, SetTimeIsBroughtIntoTheMotion) {
  webots::Motion motion{file(kNod)};
  motion.setTime(-5);
  EXPECT_EQ(motion.getTime(), 0);
  motion.setTime(1000);
  EXPECT_EQ(motion.getTime(), 64);
  EXPECT_TRUE(motion.isOver());
  motion.setTime(24);
  neckIsAt(0.3);
  motion.play();
  EXPECT_THAT(necks(2), ElementsAre(0.3, 0.3));
}

TEST_F(MotionTest, AFirstPoseThatIsFarAwayIsNotJumpedToAndTheTimeWaits) {
  jointsFollow();
  webots::Motion motion{file("#WEBOTS_MOTION,V1.0,Neck,Head\n00:00:000,A,1.2,*\n00:00:032,B,1.4,0.1\n")};
  motion.play();
  double before = fake.image.joint[index(Joint::kNeck)].commanded.value;
  int steps = 0;
  for (double goal = 0; steps < 1000 && motion.getTime() == 0; ++steps) {
    goal = neckAfterStep();
    EXPECT_LE(std::abs(goal - before), goals::LeadIn::kSpeed * 0.016 + 1e-9)
        << "rad in a step of 16 ms, step " << steps;
    EXPECT_FALSE(motion.isOver());
    before = goal;
    if (goal == 1.2) break;
  }
  EXPECT_NEAR(steps * 0.016, 1.5 * 1.2 / goals::LeadIn::kSpeed, 0.032)
      << "1.2 rad, in the middle at the greatest speed";
  EXPECT_EQ(motion.getTime(), 0);
  EXPECT_THAT(necks(2), ElementsAre(1.3, 1.4));
  EXPECT_TRUE(motion.isOver());
  motion.play();
  EXPECT_THAT(necks(1), ElementsAre(1.4)) << "back to the first pose, from where it is";
  EXPECT_FALSE(motion.isOver());
}

TEST_F(MotionTest, AFirstValueInALaterPoseIsNotJumpedTo) {
  jointsFollow();
  for (const char* const text : {"#WEBOTS_MOTION,V1.0,Neck,Head\n00:00:000,A,0,*\n00:00:016,B,0,-0.3\n",
                                 "#WEBOTS_MOTION,V1.0,Head\n00:00:500,A,0.5\n"}) {
    webots::Motion motion{file(text)};
    double before = fake.image.joint[index(Joint::kHead)].commanded.value;
    motion.play();
    for (int step = 0; step < 1000 && !motion.isOver(); ++step) {
      neckAfterStep();
      const double goal = headOfLastStep();
      ASSERT_LE(std::abs(goal - before), goals::LeadIn::kSpeed * 0.016 + 1e-9) << text << "step " << step;
      before = goal;
    }
    EXPECT_TRUE(motion.isOver());
  }
}

TEST_F(MotionTest, AFirstPoseThatIsNearComesAtOnce) {
  neckIsAt(0.5);
  for (const double first : {0.41, 0.59}) {
    webots::Motion motion{
        file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A," + std::to_string(first) + "\n00:00:032,B,0.5\n")};
    motion.play();
    EXPECT_EQ(neckAfterStep(), first);
    neckAfterStep();
    EXPECT_EQ(motion.getTime(), 16);
  }
}

TEST_F(MotionTest, AMotionOfOnePoseIsOverWhenItsMotorsAreThere) {
  jointsFollow();
  webots::Motion motion{file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,0.5\n")};
  motion.play();
  int steps = 0;
  do neckAfterStep();
  while (!motion.isOver() && ++steps < 1000);
  EXPECT_GT(steps, 30);
  EXPECT_EQ(fake.last().joint[index(Joint::kNeck)].goal.value, 0.5);
}

TEST_F(MotionTest, AnotherTimeOnTheWayToTheFirstPoseIsAnotherWay) {
  jointsFollow();
  webots::Motion motion{file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,1\n00:00:032,B,-1\n")};
  motion.play();
  necks(20);
  const double there = neckAfterStep();
  motion.setTime(32);
  EXPECT_NEAR(neckAfterStep(), there, 1e-9) << "no jump";
  for (int i = 0; i < 300 && !motion.isOver(); ++i) neckAfterStep();
  EXPECT_EQ(neckAfterStep(), -1);
}

TEST_F(MotionTest, TheClockIsTheRobotsWhateverTheStep) {
  webots::Motion motion{file(kNod)};
  motion.play();
  robot().step(16);
  robot().step(48);
  EXPECT_EQ(motion.getTime(), 16);
  robot().step(16);
  EXPECT_EQ(motion.getTime(), 64);
  EXPECT_TRUE(motion.isOver());
}

TEST_F(MotionTest, TwoMotionsPlayAtOnceAndADeletedOneNoMore) {
  webots::Motion nod{file(kNod)};
  auto arm = std::make_unique<webots::Motion>(file("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,1\n00:10:000,B,1\n", "b"));
  nod.play();
  necks(1);
  neckIsAt(1);
  arm->play();
  EXPECT_THAT(necks(1), ElementsAre(1)) << "the younger one wins";
  arm.reset();
  EXPECT_THAT(necks(1), ElementsAre(0.2));
}

TEST_F(MotionTest, MotorsThatTheRobotDoesNotHaveAreNamedOnceAndLeftOut) {
  const std::string path = file("#WEBOTS_MOTION,V1.0,Tail,Neck,Wing\n00:00:000,A,1,0.5,*\n00:00:064,B,1,0.5,*\n");
  CaptureStderr();
  webots::Motion motion{path};
  const webots::Motion again{path};
  neckIsAt(0.5);
  EXPECT_EQ(GetCapturedStderr(),
            "darwinop: Motion: " + path + ": this robot has no motor Tail, Wing; it is left out\n");
  motion.play();
  EXPECT_THAT(necks(1), ElementsAre(0.5));
}

TEST_F(MotionTest, ABrokenFileIsReportedWithLineAndFieldAndNeverMoves) {
  const std::string head = "#WEBOTS_MOTION,V1.0,Neck,Head\n";
  EXPECT_EQ(sentenceAbout(kNod), "");
  EXPECT_EQ(sentenceAbout(head + "\r\n 00:00:000 , Rest , 0 , * \r\n\n"), "") << "blanks and other line ends";
  const std::pair<std::string, std::string> kBroken[] = {
      {"", ":1: field 1: a motion file begins with #WEBOTS_MOTION"},
      {"#WEBOTS_MOTION", ":1: field 2: its version is not V1.0"},
      {"#WEBOTS_MOTION,V2.0,Neck", ":1: field 2: its version is not V1.0"},
      {"#WEBOTS_MOTION,V1.0,Neck,", ":1: field 4: a motor without a name"},
      {"#WEBOTS_MOTION,V1.0,Neck,Neck", ":1: field 4: the motor \"Neck\" has a column already"},
      {head, std::string{":2"} + messages::kNoPose},
      {head + "00:00:000,A,0,0\n00:01,B,0,0",
       ":3: field 1: \"00:01\" is not a time; it is minutes:seconds:milliseconds, 00:01:500"},
      {head + "00:00:-10,A,0,0", ":2: field 1: \"00:00:-10\" is not a time"},
      {head + "99999999:00:000,A,0,0", ":2: field 1: \"99999999:00:000\" is not a time"},
      {head + "00:01:000,A,0,0\n00:00:999,B,0,0", ":3: field 1: the time goes back"},
      {head + "00:00:000,A,0", ":2: field 4: the line has 3 fields, and the header asks for 4"},
      {head + "00:00:000,A,0,0,0", ":2: field 5: the line has 5 fields, and the header asks for 4"},
      {head + "00:00:000,A,0,left", ":2: field 4: \"left\" is neither a number, in rad, nor *"},
      {head + "00:00:000,A,nan,0", ":2: field 3: \"nan\" is neither a number, in rad, nor *"},
      {head + "00:00:000,A,0,", ":2: field 4: \"\" is neither a number, in rad, nor *"},
  };
  for (const auto& [text, sentence] : kBroken) {
    forgetWarnings();
    const std::string said = sentenceAbout(text);
    EXPECT_THAT(said, HasSubstr("darwinop: Motion: test.motion" + sentence));
    EXPECT_THAT(said, HasSubstr("; it will not be played\n"));
  }
}

TEST_F(MotionTest, APipeIsRefusedAndNotWaitedFor) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe.motion";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  CaptureStderr();
  EXPECT_FALSE(webots::Motion{pipe}.isValid());
  EXPECT_THAT(GetCapturedStderr(), AllOf(HasSubstr(pipe), HasSubstr(kPipeInsteadOfFile)));
}

TEST_F(MotionTest, AMissingFileIsReportedAndEveryCallIsHarmless) {
  CaptureStderr();
  webots::Motion motion{"no/such.motion"};
  EXPECT_EQ(GetCapturedStderr(), "darwinop: Motion: no/such.motion: it cannot be opened; it will not be played\n");
  EXPECT_FALSE(motion.isValid());
  motion.setLoop(true);
  motion.setTime(100);
  motion.play();
  EXPECT_EQ(commanded(Joint::kNeck).set, 0);
  EXPECT_EQ(motion.getTime() + motion.getDuration(), 0);
  EXPECT_TRUE(motion.isOver());
}

// The example of the simulator's robot, as it was published.
TEST(MotionText, TheExampleIsWhatItSays) {
  const MotionText motion = parseMotion(
      "#WEBOTS_MOTION,V1.0,ArmLowerL,ArmUpperL,ShoulderL\n00:00:000,Rest,-0.5,0.2,1\n00:01:000,Lift arm,0.5,*,-2\n"
      "00:02:000,Inner,*,0.77,*\n00:03:000,Outer,*,0.2,*\n00:04:000,Inner,*,0.77,*\n00:05:000,Outer,*,0.2,*\n"
      "00:05:500,Lift arm,0.5,*,-2\n00:06:000,Rest,-0.5,0.2,1",
      "hand_high.motion");
  ASSERT_EQ(motion.curves.size(), 3u);
  EXPECT_EQ(motion.duration_ms, 6000);
  EXPECT_DOUBLE_EQ(*motion.curves[0].at(500), 0);
  EXPECT_DOUBLE_EQ(*motion.curves[0].at(3000), 0.5);
  EXPECT_DOUBLE_EQ(*motion.curves[1].at(1000), 0.485);
  EXPECT_DOUBLE_EQ(*motion.curves[1].at(5500), 0.2);
  EXPECT_DOUBLE_EQ(*motion.curves[2].at(5750), -0.5);
  EXPECT_DOUBLE_EQ(*motion.curves[2].at(7000), 1);
}

TEST(MotionText, TwoPosesOfOneTimeAreAJump) {
  const MotionText motion = parseMotion("#WEBOTS_MOTION,V1.0,A\n0:0:0,,1\n0:0:10,,2\n0:0:10,,5\n0:0:20,,6", "m");
  EXPECT_DOUBLE_EQ(*motion.curves[0].at(9), 1.9);
  EXPECT_DOUBLE_EQ(*motion.curves[0].at(10), 5);
  EXPECT_DOUBLE_EQ(*motion.curves[0].at(15), 5.5);
}

}  // namespace
}  // namespace darwinop::webots_api
