// TcpLink against servers that reply correctly, incorrectly or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "remote/client/messages.hpp"
#include "scripted_robot.hpp"
#include "tcp_link_fixture.hpp"

namespace darwinop::remote {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

/// Replies as a server of 2013, without the extension.
struct OldRobot : ScriptedRobot {
  Answer operator()(Request request, int connection) {
    request.extended = false;
    return ScriptedRobot::operator()(request, connection);
  }
};

TEST_F(TcpLinkTest, ReturnsTheRobotsSensors) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  ASSERT_TRUE(stepOf(*tcp));
  const Sensors seen = tcp->sensors();
  EXPECT_EQ(seen.cycle, 1001);
  EXPECT_EQ(seen.joint[7].position.value, 0.25);
  EXPECT_EQ(seen.board.buttons, 2);
  EXPECT_EQ(seen.board.voltage.value, 11.5);
  EXPECT_EQ(seen.safety.state, State::kDriven);
  EXPECT_FALSE(tcp->realTime());
  EXPECT_EQ(said, "");
}

TEST_F(TcpLinkTest, SendsEachCommandOnceInTheServosUnits) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  {
    const auto tcp = link(server.port());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(stepOf(*tcp));
  }
  const std::vector<Request> requests = server.requests();
  ASSERT_EQ(requests.size(), 5) << "the first request, three steps, the end of the session";
  EXPECT_TRUE(requests[0].motors.empty()) << "nothing is wanted yet";
  EXPECT_FALSE(requests[0].extension.unattended);
  EXPECT_FALSE(requests[0].extension.only_if_up) << "a new controller may start the robot";
  ASSERT_EQ(requests[1].motors.size(), 1);
  EXPECT_EQ(requests[1].motors[0],
            (MotorSetting{.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = 326}))
      << "the nearest tick, as without a network";
  EXPECT_EQ(requests[1].leds.size(), 1);
  EXPECT_TRUE(requests[2].motors.empty() && requests[2].leds.empty());
  EXPECT_TRUE(requests[4].extension.end_of_session);
  EXPECT_TRUE(requests[4].extension.only_if_up) << "it does not start a robot at rest";
}

TEST_F(TcpLinkTest, SendsTheLastGoalsAndNoEndOfSessionWhenLeftHolding) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  {
    const auto tcp = link(server.port());
    ASSERT_TRUE(stepOf(*tcp));
    Commands last = wanted();
    last.joint[18].setGoal(Rad{0.25});
    tcp->publish(last);
    tcp->leaveHolding();
  }
  const std::vector<Request> requests = server.requests();
  ASSERT_EQ(requests.size(), 3) << "a greeting, a step, where it is to stay";
  ASSERT_EQ(requests[2].motors.size(), 1);
  EXPECT_EQ(requests[2].motors[0].position, 163);
  EXPECT_FALSE(requests[2].extension.end_of_session);
}

TEST_F(TcpLinkTest, EndsTheSessionIfAStepFollowsLeaveHolding) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  {
    const auto tcp = link(server.port());
    ASSERT_TRUE(stepOf(*tcp));
    tcp->leaveHolding();
    ASSERT_TRUE(stepOf(*tcp));
  }
  ASSERT_EQ(server.requests().size(), 5);
  EXPECT_TRUE(server.requests().back().extension.end_of_session);
}

TEST_F(TcpLinkTest, WorksWithA2013ServerAndMarksMissingValuesAsAbsent) {
  OldRobot robot;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  EXPECT_TRUE(tcp->realTime());
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(stepOf(*tcp));
  const Sensors seen = tcp->sensors();
  EXPECT_NEAR(seen.joint[7].position.value, 0.25, 1e-4);
  EXPECT_NEAR(seen.joint[7].load, 0.5, 1e-3) << "counter-clockwise";
  EXPECT_TRUE(seen.joint[7].motion.fresh());
  EXPECT_NEAR(seen.board.accelerometer[2].value, 9.8, 0.1);
  EXPECT_FALSE(seen.board.buttons_known);
  EXPECT_FALSE(seen.board.voltage.known());
  EXPECT_FALSE(seen.joint[7].temperature.known());
  EXPECT_FALSE(seen.joint[7].velocity.known());
  EXPECT_EQ(seen.safety.state, State::kDriven);
  EXPECT_THAT(said, HasSubstr("buttons"));
  const std::vector<Request> requests = server.requests();
  EXPECT_TRUE(requests.front().extended);
  for (std::size_t i = 1; i < requests.size(); ++i) EXPECT_FALSE(requests[i].extended) << "it would be logged there";
}

TEST_F(TcpLinkTest, ReportsWhyTheSessionMustEnd) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  ASSERT_TRUE(stepOf(*tcp));
  robot.must_end = "the MODE button was held";
  EXPECT_FALSE(stepOf(*tcp));
  EXPECT_EQ(tcp->whyEnded(), "the MODE button was held");
}

TEST_F(TcpLinkTest, ReportsOnceThatTheRobotEndsAndThenWaitsForTheLastSteps) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  {
    const auto tcp = link(server.port());
    ASSERT_TRUE(stepOf(*tcp));
    robot.end_request = "the runtime ends";
    EXPECT_FALSE(stepOf(*tcp));
    EXPECT_EQ(tcp->whyEnded(), "the runtime ends");
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(stepOf(*tcp)) << tcp->whyEnded();
  }
  EXPECT_TRUE(server.requests().back().extension.end_of_session);
}

TEST_F(TcpLinkTest, EscapesControlCharactersInTextOfAServer) {
  ScriptedRobot robot;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  ASSERT_TRUE(stepOf(*tcp));
  robot.must_end = "\x1b]0;a title\x07\x1b[2Jgone";
  EXPECT_FALSE(stepOf(*tcp));
  EXPECT_EQ(tcp->whyEnded(), "\\x1b]0;a title\\x07\\x1b[2Jgone");
}

TEST_F(TcpLinkTest, ReportsAtTheStartWhyItMayNotDrive) {
  ScriptedRobot robot;
  robot.must_end = "another controller (pid 12) drives this robot";
  ScriptedServer server{std::ref(robot)};
  try {
    (void)link(server.port());
    ADD_FAILURE() << "it drives";
  } catch (const std::runtime_error& refused) {
    EXPECT_EQ(refused.what(), robot.must_end);
  }
}

TEST_F(TcpLinkTest, ReportsThatNoServerIsThere) {
  std::uint16_t port = 0;
  {
    ScriptedRobot robot;
    port = ScriptedServer{std::ref(robot)}.port();
  }
  try {
    (void)link(port);
    ADD_FAILURE() << "a server is there";
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kNoServer));
  }
  EXPECT_THAT(said, HasSubstr("tcp://127.0.0.1:"));
}

TEST_F(TcpLinkTest, ReportsAServerOfAnotherProtocol) {
  ScriptedServer mute{[](const Request&, int) { return Answer{}; }};
  EXPECT_THROW((void)link(mute.port()), std::runtime_error);
  ScriptedServer rude{[](const Request&, int) { return Answer{{'W', 0xFF, 0xFF, 0xFF, 0xFF}}; }};
  try {
    (void)link(rude.port());
    ADD_FAILURE() << "that is no server";
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kInvalidReply));
  }
}

TEST_F(TcpLinkTest, RefusesCyclesAndTimesThatNoLoopHas) {
  using Distortion = void (*)(Sensors & seen);
  for (const Distortion distort :
       {Distortion{[](Sensors& seen) { seen.cycle = std::uint64_t{1} << 61; }},
        Distortion{[](Sensors& seen) { seen.cycle = ~std::uint64_t{0}; }},
        Distortion{[](Sensors& seen) { seen.time_ns = std::numeric_limits<std::int64_t>::min(); }}}) {
    said.clear();
    std::atomic<int> replies{0};
    ScriptedRobot robot;
    robot.real_time = true;
    robot.distort = [&](Sensors& seen) {
      if (++replies == 3) distort(seen);
    };
    ScriptedServer server{std::ref(robot)};
    const auto tcp = link(server.port());
    for (int i = 0; i < 200 && said.find(messages::kConnectedAgain) == std::string::npos; ++i)
      ASSERT_TRUE(stepOf(*tcp)) << tcp->whyEnded();
    EXPECT_THAT(said, HasSubstr(messages::kInvalidReply));
    EXPECT_LT(tcp->sensors().cycle, 10'000);
  }
}

TEST_F(TcpLinkTest, RefusesAFirstReplyWithATimeThatNoLoopHas) {
  ScriptedRobot robot;
  robot.distort = [](Sensors& seen) { seen.time_ns = std::numeric_limits<std::int64_t>::max(); };
  ScriptedServer server{std::ref(robot)};
  try {
    (void)link(server.port());
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kInvalidReply));
  }
}

TEST_F(TcpLinkTest, IgnoresAPeriodThatNoLoopHas) {
  for (const std::int64_t period_ns : {std::int64_t{1}, std::int64_t{1} << 62}) {
    ScriptedRobot robot;
    robot.distort = [&](Sensors& seen) { seen.period_ns = period_ns; };
    ScriptedServer server{std::ref(robot)};
    EXPECT_EQ(link(server.port())->period(), 16ms);
  }
}

TEST_F(TcpLinkTest, AcceptsAReplyInSingleBytes) {
  ScriptedRobot robot;
  ScriptedServer server{[&](const Request& request, int connection) {
    Answer answer = robot(request, connection);
    answer.trickles = true;
    return answer;
  }};
  const auto tcp = link(server.port());
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_EQ(tcp->sensors().cycle, 1003);
}

}  // namespace
}  // namespace darwinop::remote
