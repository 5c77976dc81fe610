// Keys as controllers ask for them, in today's style and in that of 2013.
#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>
#include <webots/Keyboard.hpp>

#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using webots::Keyboard;

class KeyboardTest : public Facade {
 protected:
  Keyboard& keyboard() { return *robot().getKeyboard(); }
  std::vector<int> all() {
    std::vector<int> keys;
    for (int key = keyboard().getKey(); key != -1; key = keyboard().getKey()) keys.push_back(key);
    return keys;
  }
  std::vector<int> afterAStep() {
    EXPECT_EQ(robot().step(16), 0);
    return all();
  }
};

TEST_F(KeyboardTest, ReturnsEachKeyOnceAStepForAsLongAsItIsHeld) {
  keyboard().enable(16);
  held = {Keyboard::UP, ' ', 'A' | Keyboard::SHIFT};
  EXPECT_THAT(all(), IsEmpty()) << "before the first step";
  for (int step = 0; step < 2; ++step) EXPECT_THAT(afterAStep(), ElementsAre(315, 32, 65 | 0x10000));
  EXPECT_THAT(all(), IsEmpty());
  held = {' '};
  EXPECT_THAT(afterAStep(), ElementsAre(32));
  held = {};
  EXPECT_THAT(afterAStep(), IsEmpty());
}

TEST_F(KeyboardTest, ForgetsAKeyThatNobodyAskedForInItsStep) {
  keyboard().enable(16);
  held = {'A'};
  EXPECT_EQ(robot().step(16), 0);
  held = {'B'};
  EXPECT_THAT(afterAStep(), ElementsAre('B'));
}

TEST_F(KeyboardTest, IsLookedAtInItsSamplingPeriod) {
  keyboard().enable(48);
  EXPECT_EQ(keyboard().getSamplingPeriod(), 48);
  held = {'A'};
  std::vector<std::size_t> counts;
  for (int step = 0; step < 7; ++step) counts.push_back(afterAStep().size());
  EXPECT_THAT(counts, ElementsAre(1, 0, 0, 1, 0, 0, 1));
}

TEST_F(KeyboardTest, IsOpenedOnceAndClosedByDisable) {
  held = {'A'};
  EXPECT_THAT(afterAStep(), IsEmpty()) << "not enabled";
  EXPECT_EQ(keys_opened, 0);
  keyboard().enable(16);
  keyboard().enable(32);
  EXPECT_EQ(keys_opened, 1);
  EXPECT_THAT(afterAStep(), ElementsAre('A'));
  keyboard().disable();
  EXPECT_EQ(keyboard().getSamplingPeriod(), 0);
  EXPECT_THAT(afterAStep(), IsEmpty());
  keyboard().enable(16);
  keyboard().enable(0);
  EXPECT_THAT(afterAStep(), IsEmpty());
  EXPECT_EQ(keys_opened, 2);
}

TEST_F(KeyboardTest, AnErrorIsReportedAndNothingIsPressed) {
  robot();
  testing::internal::CaptureStderr();
  why_no_keys = "DARWINOP_KEYS=piano";
  keyboard().enable(16);
  EXPECT_THAT(afterAStep(), IsEmpty());
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("DARWINOP_KEYS=piano"));
}

/// As upstream's walk does it: constants of a class that is a robot, and 0 for no more.
class Walker2013 : public webots::Robot {
 public:
  explicit Walker2013(RobotImpl* impl) : Robot(impl) { keyboardEnable(16); }
  void oneStep() {
    ASSERT_EQ(step(16), 0);
    int key = 0;
    while ((key = keyboardGetKey()) != 0) switch (key) {
        case ' ':
          walks = !walks;
          break;
        case KEYBOARD_UP:
          x = 1;
          break;
        case KEYBOARD_LEFT:
          a = 0.5;
          break;
        default:
          other = key;
      }
  }
  bool walks = false;
  double x = 0, a = 0;
  int other = 0;
};

TEST_F(KeyboardTest, WorksInTheStyleOf2013) {
  Walker2013 walker{makeImpl()};
  held = {' ', 315, 314, 'X'};
  walker.oneStep();
  EXPECT_TRUE(walker.walks);
  EXPECT_EQ(walker.x, 1);
  EXPECT_EQ(walker.a, 0.5);
  EXPECT_EQ(walker.other, 'X');
  EXPECT_EQ(walker.keyboardGetKey(), 0);
  walker.keyboardDisable();
  walker.oneStep();
  EXPECT_TRUE(walker.walks);
}

}  // namespace
}  // namespace darwinop::webots_api
