// Who may drive, what reaches the robot, and when it is held.
#include "window/driver.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <string>
#include <vector>

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

struct HelmOnPaper final : window::Helm {
  void begin() override {
    now = {.state = refusal.empty() ? State::kDriving : State::kFree, .why = refusal};
    end = "";
  }
  void order(const window::Orders& orders) override { ordered.push_back(orders); }
  void stop() override { letGo("stop"); }
  void leave() override { letGo("leave"); }
  Report report() override { return now; }
  void letGo(const char* how) {
    now = {};
    end = how;
  }

  Report now{};
  std::string refusal, end;
  std::vector<window::Orders> ordered;
};

struct Page final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override { heard = *text; }
  void sendBinary(web::Lane, web::Bytes) override {}
  void forgetNewest() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string heard, who = "page";
};

struct WindowDriver : testing::Test {
  void take() {
    driver.said(page, R"({"take": true})", false);
    driver.turn();
  }
  void say(const char* words) {
    driver.said(page, words, false);
    driver.turn();
  }

  Nanos now{0};
  HelmOnPaper helm;
  Page page, other;
  window::Driver driver{helm, [this] { return now; }};
};

TEST_F(WindowDriver, NobodyMovesTheRobotBeforeItIsTaken) {
  say(R"({"goals": {"Neck": 0.3}})");
  EXPECT_TRUE(helm.ordered.empty());
}

TEST_F(WindowDriver, TheNewestGoalIsOrderedOnce) {
  take();
  EXPECT_THAT(page.heard, HasSubstr(R"("yours":true)"));
  driver.said(page, R"({"goals": {"Neck": 0.1}})", false);
  say(R"({"goals": {"Neck": 0.3}})");
  EXPECT_EQ(helm.ordered.back().goals[index(Joint::kNeck)].value_or(Rad{}).value, 0.3);
  driver.turn();
  EXPECT_FALSE(helm.ordered.back().goals[index(Joint::kNeck)]);
}

TEST_F(WindowDriver, AWalkLastsWhileThePageSaysSo) {
  take();
  say(R"({"walk": {"x": 0.5, "a": -3}})");
  driver.turn();
  ASSERT_TRUE(helm.ordered.back().walk);
  EXPECT_EQ(helm.ordered.back().walk->x, 0.5);
  EXPECT_EQ(helm.ordered.back().walk->a, -1);
  say("{}");
  EXPECT_FALSE(helm.ordered.back().walk);
}

TEST_F(WindowDriver, PagesAndTorqueAreOrderedOnceAndWhatComesOfItIsTold) {
  take();
  say(R"({"page": 9, "torque": {"left_arm": false}})");
  EXPECT_EQ(helm.ordered.back().page, 9);
  EXPECT_EQ(helm.ordered.back().torque[1], false);
  driver.turn();
  EXPECT_EQ(helm.ordered.back().page, 0);
  EXPECT_FALSE(helm.ordered.back().torque[1]);
  helm.now.doings = {.page = 9, .limp = 2, .refused = "no"};
  driver.turn();
  EXPECT_THAT(page.heard, HasSubstr(R"("limp":["left_arm"],"page":9,"refused":"no")"));
}

TEST_F(WindowDriver, ASecondPageIsRefusedAndMovesNothing) {
  take();
  driver.said(other, R"({"take": true, "goals": {"Neck": 0.3}})", false);
  EXPECT_THAT(other.heard, HasSubstr("another page drives"));
  driver.said(other, R"({"stop": true})", false);
  driver.turn();
  EXPECT_FALSE(helm.ordered.back().goals[index(Joint::kNeck)]);
  EXPECT_EQ(helm.end, "");
}

TEST_F(WindowDriver, AStopIsAtOnceAndWhoGoesAwayLetsTheStepEnd) {
  take();
  say(R"({"stop": true})");
  EXPECT_EQ(helm.end, "stop");
  take();
  say(R"({"leave": true})");
  EXPECT_EQ(helm.end, "leave");

  take();
  now += window::Driver::kPatience;
  driver.turn();
  EXPECT_EQ(helm.end, "");
  now += 1ms;
  driver.turn();
  EXPECT_EQ(helm.end, "leave");
  EXPECT_THAT(page.heard, HasSubstr("not heard"));

  take();
  driver.closed(page);
  EXPECT_EQ(helm.end, "leave");
  EXPECT_FALSE(driver.drives());
}

TEST_F(WindowDriver, NobodyTakesARobotThatStillComesToRest) {
  helm.now.state = window::Helm::State::kEnding;
  take();
  EXPECT_FALSE(driver.drives());
  EXPECT_THAT(page.heard, HasSubstr("coming to rest"));
}

TEST_F(WindowDriver, WhatIsNotUnderstoodIsNoSignOfLife) {
  take();
  now += window::Driver::kPatience;
  for (const char* nonsense :
       {"", "[]", "{", R"({"take": 1})", R"({"goals": [1]})", R"({"goals": {"Nose": 1}})",
        R"({"goals": {"Neck": "up"}})", R"({"goals": {"Neck": null}})", R"({"walk": {"z": 1}})",
        R"({"walk": {"x": "1"}})", R"({"walk": 1})", R"({"page": 0})", R"({"page": 256})", R"({"page": 1.5})",
        R"({"torque": {"tail": true}})", R"({"torque": {"head": 1}})", R"({"leave": 1})", "\xff\xfe"}) {
    driver.said(page, nonsense, false);
    EXPECT_THAT(page.heard, testing::Not(HasSubstr(R"("text":"")"))) << nonsense;
  }
  driver.said(page, "{}", true);
  now += 1ms;
  driver.turn();
  EXPECT_EQ(helm.end, "leave");
}

TEST_F(WindowDriver, ARefusedLeaseAndAFaultAreToldInWords) {
  helm.refusal = "another controller drives";
  take();
  EXPECT_THAT(page.heard, HasSubstr("another controller drives"));
  EXPECT_FALSE(driver.drives());
  helm.refusal.clear();
  take();
  helm.now = {.why = "the supply is under 10.0 V"};
  driver.turn();
  EXPECT_THAT(page.heard, HasSubstr("under 10.0 V"));
  EXPECT_FALSE(driver.drives());
}

}  // namespace
}  // namespace darwinop
