// A robot that comes late: what is waited for, what is not, and what is logged.
#include "connect/wait_for_bus.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/cm730/not_ready.hpp"

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

struct Wait : ::testing::Test {
  std::atomic<bool> stop{false};
  int attempts = 0, comes_at = 1;
  Nanos now{0};
  std::vector<Nanos> asked_at;
  std::vector<std::string> logged;

  OpenedBus open() {
    ++attempts;
    asked_at.push_back(now);
    if (attempts < comes_at) throw cm730::NotReady(obstacle(attempts));
    return {nullptr, {}, "/dev/ttyUSB0", ""};
  }
  std::function<std::string(int)> obstacle = [](int) { return std::string{"there is no /dev/ttyUSB0"}; };
  std::optional<OpenedBus> wait() {
    return waitForBus([&] { return open(); }, stop, [&](const std::string& what) { logged.push_back(what); },
                      [&](Nanos time) {
                        now += time;
                        if (now >= 60s) stop = true;
                      });
  }
};

TEST_F(Wait, ARobotThatIsThereIsTakenAtOnceAndWithoutAWord) {
  EXPECT_TRUE(wait());
  EXPECT_EQ(now, 0s);
  EXPECT_THAT(logged, ElementsAre());
}

TEST_F(Wait, SaysOnceWhatItWaitsForAndOnceThatItCame) {
  comes_at = 7;
  EXPECT_TRUE(wait());
  EXPECT_THAT(logged,
              ElementsAre("waiting for the robot: there is no /dev/ttyUSB0", "the robot is there: /dev/ttyUSB0"));
}

TEST_F(Wait, SaysAgainWhatItWaitsForWhenThatChangesButNotForAnotherFigure) {
  obstacle = [](int attempt) {
    const std::string figure = std::to_string(attempt);
    return attempt < 4 ? "supply " + figure + " V" : "servo is silent, supply " + figure + " V";
  };
  comes_at = 7;
  EXPECT_TRUE(wait());
  EXPECT_THAT(logged,
              ElementsAre("waiting for the robot: supply 1 V", "waiting for the robot: servo is silent, supply 4 V",
                          "the robot is there: /dev/ttyUSB0"));
}

TEST_F(Wait, AsksLessAndLessOftenButEveryTwoSeconds) {
  comes_at = 7;
  EXPECT_TRUE(wait());
  EXPECT_THAT(asked_at, ElementsAre(0ms, 200ms, 600ms, 1400ms, 3000ms, 5000ms, 7000ms));
}

TEST_F(Wait, EndsWhenAskedTo) {
  comes_at = 1'000'000;
  EXPECT_FALSE(wait());
  EXPECT_LT(now, 60s + 200ms);
}

TEST_F(Wait, AnotherErrorIsNotWaitedFor) {
  const auto wrong = []() -> OpenedBus { throw std::runtime_error("other"); };
  const auto pause = [&](Nanos) { stop = true; };
  EXPECT_THROW(static_cast<void>(waitForBus(
                   wrong, stop, [](const std::string&) {}, pause)),
               std::runtime_error);
}

TEST(NotReady, IsAPortThatIsNotThere) {
  EXPECT_THROW(openSerialBus({"/dev/ttyNOSUCHPORT"}), cm730::NotReady);
}

TEST(NotReady, IsNotAPortThatIsNotAPortAndNotAWrongPeriod) {
  for (const auto& [port, period] : {std::pair{"/dev/null", 16ms}, std::pair{"/dev/ttyNOSUCHPORT", 1ms}}) {
    try {
      static_cast<void>(openSerialBus({port, period}));
      ADD_FAILURE() << port;
    } catch (const cm730::NotReady& waited_for) {
      ADD_FAILURE() << waited_for.what();
    } catch (const std::runtime_error&) {
    }
  }
}

}  // namespace
}  // namespace darwinop::connect
