// Lights: commands to the board, and values of get().
#include <webots/LED.hpp>

#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

class LedTest : public Facade {
 protected:
  LedCommand commanded() {
    EXPECT_EQ(robot().step(16), 0);
    return fake.last().led;
  }
  webots::LED& led(const char* name) { return *robot().getLED(name); }
};

TEST_F(LedTest, NothingIsCommandedUntilALightIsSet) {
  EXPECT_EQ(commanded().set, 0);
}

TEST_F(LedTest, ColoursBecomeFifteenBits) {
  led("EyeLed").set(0x00FF00);
  led("HeadLed").set(0xFF0000);
  EXPECT_EQ(commanded().eye, 0x03E0);
  EXPECT_EQ(commanded().head, 0x001F);
  EXPECT_FALSE(commanded().has(LedCommand::kPanel));
}

TEST_F(LedTest, GetReturnsTheColourThatWasSet) {
  led("EyeLed").set(0x123456);
  EXPECT_EQ(led("EyeLed").get(), 0x123456);
}

TEST_F(LedTest, GetBeforeSetIsWhatTheBoardShows) {
  fake.image.board.led_head = 0x001F;
  fake.image.board.led_panel = 4;
  EXPECT_EQ(led("HeadLed").get(), 0xFF0000);
  EXPECT_EQ(led("BackLedGreen").get(), 1);
  EXPECT_EQ(led("BackLedRed").get(), 0);
}

TEST_F(LedTest, BackLedsShareARegisterWithoutDisturbingEachOther) {
  led("BackLedRed").set(1);
  led("BackLedGreen").set(1);
  EXPECT_EQ(commanded().panel, 5);
  led("BackLedBlue").set(1);
  led("BackLedRed").set(0);
  EXPECT_EQ(commanded().panel, 6);
}

TEST_F(LedTest, ABackLedSetAgainStaysOn) {
  for (int i = 0; i < 5; ++i) {
    led("BackLedRed").set(1);
    EXPECT_EQ(commanded().panel, 1);
  }
}

TEST_F(LedTest, AnyValueButZeroIsOn) {
  led("BackLedBlue").set(255);
  EXPECT_EQ(commanded().panel, 2);
  EXPECT_EQ(led("BackLedBlue").get(), 1);
}

TEST_F(LedTest, TheFirstSetKeepsTheLightsThatAreOn) {
  fake.image.board.led_panel = 4;
  led("BackLedRed").set(1);
  EXPECT_EQ(commanded().panel, 5);
}

}  // namespace
}  // namespace darwinop::webots_api
