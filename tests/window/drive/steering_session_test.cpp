// Steering session: takeover, requests, heartbeat, end.
#include "window/drive/steering_session.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <string>
#include <vector>

#include "window/messages.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

struct FakeDrive final : window::DriveInterface {
  void start() override {
    now = {.state = refusal.empty() ? window::DriveState::kDriving : window::DriveState::kFree, .why = refusal};
    end = "";
  }
  void request(const window::DriveRequests& requests) override { requested.push_back(requests); }
  void stop() override { endSession("stop"); }
  void finish() override { endSession("leave"); }
  Report report() override { return now; }
  void endSession(const char* how) {
    now = {.state = steps_to_complete ? window::DriveState::kEnding : window::DriveState::kFree};
    end = how;
  }

  Report now{};
  std::string refusal, end;
  bool steps_to_complete = false;
  std::vector<window::DriveRequests> requested;
};

struct Page final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override { received = *text; }
  void sendBinary(web::Lane, web::Bytes) override {}
  void discardQueued() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string received, who = "page";
};

struct WindowSteeringSession : testing::Test {
  void take() {
    session.received(page, R"({"take": true})", false);
    session.update();
  }
  void send(const char* request) {
    session.received(page, request, false);
    session.update();
  }

  Nanos now{0};
  FakeDrive drive;
  Page page, other;
  window::SteeringSession session{drive, [this] { return now; }};
};

TEST_F(WindowSteeringSession, IgnoresRequestsBeforeTheTakeover) {
  send(R"({"goals": {"Neck": 0.3}})");
  EXPECT_TRUE(drive.requested.empty());
}

TEST_F(WindowSteeringSession, RequestsTheNewestGoalOnce) {
  take();
  EXPECT_THAT(page.received, HasSubstr(R"("yours":true)"));
  session.received(page, R"({"goals": {"Neck": 0.1}})", false);
  send(R"({"goals": {"Neck": 0.3}})");
  EXPECT_EQ(drive.requested.back().goals[index(Joint::kNeck)].value_or(Rad{}).value, 0.3);
  session.update();
  EXPECT_FALSE(drive.requested.back().goals[index(Joint::kNeck)]);
}

TEST_F(WindowSteeringSession, AWalkLastsWhileThePageRequestsIt) {
  take();
  send(R"({"walk": {"x": 0.5, "a": -3}})");
  session.update();
  ASSERT_TRUE(drive.requested.back().walk);
  EXPECT_EQ(drive.requested.back().walk->x, 0.5);
  EXPECT_EQ(drive.requested.back().walk->a, -1);
  send("{}");
  EXPECT_FALSE(drive.requested.back().walk);
}

TEST_F(WindowSteeringSession, RequestsPagesAndTorqueOnceAndSendsTheStatus) {
  take();
  send(R"({"page": 9, "torque": {"left_arm": false}})");
  EXPECT_EQ(drive.requested.back().page, 9);
  EXPECT_EQ(drive.requested.back().torque[1], false);
  session.update();
  EXPECT_EQ(drive.requested.back().page, 0);
  EXPECT_FALSE(drive.requested.back().torque[1]);
  drive.now.status = {.page = 9, .limp = 2, .refused = "no"};
  session.update();
  EXPECT_THAT(page.received, HasSubstr(R"("limp":["left_arm"],"page":9,"refused":"no")"));
}

TEST_F(WindowSteeringSession, RefusesASecondPage) {
  take();
  session.received(other, R"({"take": true, "goals": {"Neck": 0.3}})", false);
  EXPECT_THAT(other.received, HasSubstr(window::messages::kAnotherPageDrives));
  session.update();
  EXPECT_FALSE(drive.requested.back().goals[index(Joint::kNeck)]);
  EXPECT_EQ(drive.end, "");
}

TEST_F(WindowSteeringSession, EveryPageCanStopTheRobot) {
  take();
  session.received(other, R"({"stop": true})", false);
  EXPECT_EQ(drive.end, "stop");
  EXPECT_THAT(page.received, HasSubstr(window::messages::kAnotherPageStopped));
  EXPECT_FALSE(session.drives());
}

/// A walk takes seconds to end, at the edge of a table perhaps, and the page that lost it may be back.
TEST_F(WindowSteeringSession, StopWorksWhileTheLastStepsAreCompleted) {
  take();
  drive.steps_to_complete = true;
  send(R"({"leave": true})");
  EXPECT_EQ(drive.end, "leave");
  EXPECT_THAT(page.received, HasSubstr(R"("ending":true)"));
  session.opened(other);
  EXPECT_THAT(other.received, HasSubstr(R"("ending":true)"));
  drive.steps_to_complete = false;
  session.received(page, R"({"stop": true})", false);
  EXPECT_EQ(drive.end, "stop");
  session.update();
  EXPECT_THAT(other.received, HasSubstr(R"("ending":false)"));
  EXPECT_THAT(page.received, HasSubstr(R"("ending":false)"));
}

TEST_F(WindowSteeringSession, APageThatLostTheRobotGetsTheReasonAtTheEndWhateverAnotherPageDoes) {
  take();
  drive.steps_to_complete = true;
  now += window::SteeringSession::kHeartbeatTimeout + 1ms;
  session.update();
  EXPECT_THAT(page.received, HasSubstr(R"("ending":true)"));
  session.opened(other);
  drive.now.state = window::DriveState::kFree;
  session.received(other, R"({"take": true})", false);
  EXPECT_THAT(page.received, AllOf(HasSubstr(R"("ending":false)"), HasSubstr(window::messages::kNoHeartbeat)));
  EXPECT_TRUE(session.drives());
}

TEST_F(WindowSteeringSession, StopHoldsAtOnceAndALostPageCompletesItsStep) {
  take();
  send(R"({"stop": true})");
  EXPECT_EQ(drive.end, "stop");
  take();
  send(R"({"leave": true})");
  EXPECT_EQ(drive.end, "leave");

  take();
  now += window::SteeringSession::kHeartbeatTimeout;
  session.update();
  EXPECT_EQ(drive.end, "");
  now += 1ms;
  session.update();
  EXPECT_EQ(drive.end, "leave");
  EXPECT_THAT(page.received, HasSubstr(window::messages::kNoHeartbeat));

  take();
  session.closed(page);
  EXPECT_EQ(drive.end, "leave");
  EXPECT_FALSE(session.drives());
}

TEST_F(WindowSteeringSession, ACancelledTakeoverSaysThatALimpRobotStaysLimp) {
  for (const char* how : {R"({"stop": true})", R"({"leave": true})"}) {
    session.received(page, R"({"take": true})", false);
    drive.now.state = window::DriveState::kStarting;
    send(how);
    EXPECT_THAT(page.received, HasSubstr(window::messages::kTakeoverCancelled));
  }
  session.received(page, R"({"take": true})", false);
  drive.now.state = window::DriveState::kStarting;
  session.received(other, R"({"stop": true})", false);
  EXPECT_THAT(page.received, HasSubstr(window::messages::kAnotherPageCancelled));
}

/// The drive thread is ahead of the session.
TEST_F(WindowSteeringSession, OnceTheRobotHasTorqueItHoldsAtTheEnd) {
  for (const char* how : {R"({"stop": true})", R"({"leave": true})"}) {
    session.received(page, R"({"take": true})", false);
    ASSERT_EQ(drive.now.state, window::DriveState::kDriving);
    send(how);
    EXPECT_THAT(page.received, HasSubstr(window::messages::kDrivingEnded));
  }
}

TEST_F(WindowSteeringSession, OnlyARobotThatWasDrivenCompletesItsStep) {
  drive.now.state = window::DriveState::kEnding;
  session.opened(page);
  EXPECT_THAT(page.received, HasSubstr(window::messages::kCompletesItsStep));
  drive.now.state = window::DriveState::kHolding;
  session.opened(other);
  EXPECT_THAT(other.received, HasSubstr(window::messages::kSessionEnds));
}

TEST_F(WindowSteeringSession, RefusesATakeoverWhileTheRobotComesToRest) {
  drive.now.state = window::DriveState::kEnding;
  take();
  EXPECT_FALSE(session.drives());
  EXPECT_THAT(page.received, HasSubstr(window::messages::kPreviousSessionEnds));
}

TEST_F(WindowSteeringSession, AnInvalidRequestDoesNotCountAsAHeartbeat) {
  take();
  now += window::SteeringSession::kHeartbeatTimeout;
  for (const char* nonsense :
       {"", "[]", "{", R"({"take": 1})", R"({"goals": [1]})", R"({"goals": {"Nose": 1}})",
        R"({"goals": {"Neck": "up"}})", R"({"goals": {"Neck": null}})", R"({"walk": {"z": 1}})",
        R"({"walk": {"x": "1"}})", R"({"walk": 1})", R"({"page": 0})", R"({"page": 256})", R"({"page": 1.5})",
        R"({"torque": {"tail": true}})", R"({"torque": {"head": 1}})", R"({"leave": 1})", "\xff\xfe"}) {
    session.received(page, nonsense, false);
    EXPECT_THAT(page.received, testing::Not(HasSubstr(R"("text":"")"))) << nonsense;
  }
  session.received(page, "{}", true);
  now += 1ms;
  session.update();
  EXPECT_EQ(drive.end, "leave");
}

TEST_F(WindowSteeringSession, ReportsARefusedLeaseAndAFaultAsText) {
  drive.refusal = "another controller drives";
  take();
  EXPECT_THAT(page.received, HasSubstr("another controller drives"));
  EXPECT_FALSE(session.drives());
  drive.refusal.clear();
  take();
  drive.now = {.why = "empty battery"};
  session.update();
  EXPECT_THAT(page.received, HasSubstr("empty battery"));
  EXPECT_FALSE(session.drives());
}

}  // namespace
}  // namespace darwinop
