// TcpLink against servers that reply correctly, incorrectly or not at all.
#include "remote/client/tcp_link.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "remote/client/messages.hpp"
#include "scripted_robot.hpp"

namespace darwinop::remote {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

const std::atomic<bool> kGoOn{false};

/// Replies as a server of 2013, without the extension.
struct OldRobot : ScriptedRobot {
  Answer operator()(Request request, int connection) {
    request.extended = false;
    return ScriptedRobot::operator()(request, connection);
  }
};

class TcpLinkTest : public testing::Test {
 protected:
  [[nodiscard]] std::unique_ptr<TcpLink> link(std::uint16_t port) {
    TcpOptions options;
    options.port = port;
    options.connect_timeout = 500ms;
    options.reconnect_timeout = patience;
    options.reply_timeout = reply_timeout;
    options.log = [this](const std::string& what) { said += what + "\n"; };
    return std::make_unique<TcpLink>(std::move(options));
  }
  static bool stepOf(TcpLink& link, std::uint64_t cycles = 1) {
    link.publish(wanted());
    return link.waitForCycle(link.sensors().cycle + cycles, kGoOn);
  }
  static Commands wanted() {
    Commands commands;
    commands.joint[18].setGoal(Rad{0.5});
    commands.led.setEye(31);
    return commands;
  }
  std::string said;
  Nanos patience = 20s, reply_timeout = 300ms;
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

/// Replies once, then cuts each reply one byte later; the next connection gets a whole reply and is closed as well.
struct CuttingRobot {
  ScriptedRobot robot;
  int greeted_on = -1;
  std::size_t cut_at = 0;
  std::atomic<bool> done{false};

  Answer operator()(const Request& request, int connection) {
    Answer answer = robot(request, connection);
    if (std::exchange(greeted_on, connection) != connection) return answer;
    answer.cut_at = connection % 2 == 0 ? cut_at++ : answer.bytes.size();
    done = cut_at >= answer.bytes.size() - 1;  // a reply is complete without its NUL
    return answer;
  }
};

TEST_F(TcpLinkTest, ReconnectsAfterACutAtEveryByteOfAReply) {
  CuttingRobot robot;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  std::uint64_t last = tcp->sensors().cycle;
  int steps = 0;
  for (; !robot.done; ++steps) {
    ASSERT_TRUE(stepOf(*tcp)) << tcp->whyEnded();
    ASSERT_GT(tcp->sensors().cycle, last) << "cycles never go back";
    ASSERT_EQ(tcp->sensors().joint[7].position.value, 0.25) << steps;
    last = tcp->sensors().cycle;
  }
  EXPECT_GT(steps, 800);
  EXPECT_THAT(said, HasSubstr(messages::kConnectionLost));
  EXPECT_THAT(said, HasSubstr(messages::kConnectedAgain));
}

TEST_F(TcpLinkTest, SendsAllCommandsAfterAReconnectAndStartsAtThePresentPosition) {
  ScriptedRobot robot;
  auto server = std::make_unique<ScriptedServer>(std::ref(robot));
  const std::uint16_t port = server->port();
  const auto tcp = link(port);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(stepOf(*tcp));
  server.reset();
  ScriptedRobot next;
  next.first_cycle = 1;  // a restarted loop
  ScriptedServer again{std::ref(next), port};
  const std::uint64_t before = tcp->sensors().cycle;
  ASSERT_TRUE(stepOf(*tcp, 3));
  EXPECT_GE(tcp->sensors().cycle, before + 3);
  std::size_t sent = 0;
  for (const Request& request : again.requests()) {
    EXPECT_TRUE(request.extension.start_where_it_is);
    EXPECT_TRUE(request.extension.only_if_up) << "the robot may have been released";
    EXPECT_TRUE(request.extension.unattended) << "not restarted by a person";
    sent += request.motors.size();
  }
  EXPECT_EQ(sent, 1) << "a new connection gets it once";
}

TEST_F(TcpLinkTest, ARobotThatHadNoTorqueYetMayBeStartedAfterAReconnect) {
  ScriptedRobot robot;
  robot.takes_over = true;
  auto server = std::make_unique<ScriptedServer>(std::ref(robot));
  const std::uint16_t port = server->port();
  const auto tcp = link(port);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(stepOf(*tcp));
  server.reset();
  ScriptedServer again{std::ref(robot), port};
  ASSERT_TRUE(stepOf(*tcp, 3));
  for (const Request& request : again.requests()) EXPECT_FALSE(request.extension.only_if_up);
}

/// The server takes over with the first request, before anything is published.
TEST_F(TcpLinkTest, ALinkThatStartsWhereTheRobotIsSaysSoInItsFirstRequest) {
  for (const bool in_place : {false, true}) {
    ScriptedRobot robot;
    ScriptedServer server{std::ref(robot)};
    TcpOptions options;
    options.port = server.port();
    options.start_where_it_is = in_place;
    TcpLink tcp{std::move(options)};
    EXPECT_EQ(server.requests().front().extension.start_where_it_is, in_place);
    ASSERT_TRUE(stepOf(tcp));
    EXPECT_FALSE(server.requests().back().extension.start_where_it_is) << "the commands say it themselves";
  }
}

TEST_F(TcpLinkTest, ContinuesStepsWithAgingValuesWithoutReplies) {
  ScriptedRobot robot;
  robot.real_time = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  ASSERT_TRUE(stepOf(*tcp));
  robot.silent = true;
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(stepOf(*tcp, 2));
  EXPECT_GE(tcp->sensors().joint[7].motion.age, 8) << "never an old value as a fresh one";
  EXPECT_GE(tcp->sensors().board.motion.age, 8);
  while (said.empty()) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_THAT(said, HasSubstr(messages::kNoReplyFor));
  robot.silent = false;
  while (!tcp->sensors().joint[7].motion.fresh()) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_THAT(said, HasSubstr(messages::kConnectedAgain));
}

TEST_F(TcpLinkTest, ARobotWithoutRepliesCountsAsHolding) {
  reply_timeout = 10s;
  ScriptedRobot robot;
  robot.real_time = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  ASSERT_TRUE(stepOf(*tcp));
  robot.delay = 2s;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_EQ(tcp->sensors().safety.state, State::kDriven) << "0.16 s";
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_EQ(tcp->sensors().safety.state, State::kHolding) << "0.64 s";
  for (int i = 0; i < 200 && tcp->sensors().safety.state != State::kDriven; ++i) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_EQ(tcp->sensors().safety.state, State::kDriven) << "a reply";
  EXPECT_EQ(said, "") << "the connection was not lost";
}

TEST_F(TcpLinkTest, AgesAReplyThatWasBuffered) {
  ScriptedRobot robot;
  robot.real_time = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  robot.delay = 250ms;
  while (server.requests().size() < 3) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_GT(server.requests()[2].extension.until_cycle, 1003) << "the loop has continued in the meantime";
}

TEST_F(TcpLinkTest, RequestsTheNextCycleOfALoopThatStoodStill) {
  ScriptedRobot robot;
  robot.real_time = robot.delay_is_held = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  robot.delay = 250ms;
  while (server.requests().size() < 3) ASSERT_TRUE(stepOf(*tcp));
  EXPECT_EQ(server.requests()[2].extension.until_cycle, 1001) << "the loop has run no cycle in the meantime";
}

TEST_F(TcpLinkTest, GivesFreshValuesToAControllerThatStepsLate) {
  ScriptedRobot robot;
  robot.real_time = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  std::this_thread::sleep_for(200ms);  // it computes
  ASSERT_TRUE(stepOf(*tcp));
  EXPECT_TRUE(tcp->sensors().joint[7].motion.fresh());
}

TEST_F(TcpLinkTest, EndsWhenReconnectingTimesOut) {
  patience = 100ms;
  ScriptedRobot robot;
  robot.real_time = true;
  auto server = std::make_unique<ScriptedServer>(std::ref(robot));
  const auto tcp = link(server->port());
  ASSERT_TRUE(stepOf(*tcp));
  server.reset();
  while (stepOf(*tcp)) EXPECT_TRUE(tcp->sensors().joint[7].motion.ever());
  EXPECT_THAT(tcp->whyEnded(), HasSubstr(messages::kNotRestored));
}

TEST_F(TcpLinkTest, EndsAWaitAtOnceOnRequestAndThenWaitsForTheLastSteps) {
  ScriptedRobot robot;
  robot.real_time = true;
  ScriptedServer server{std::ref(robot)};
  const auto tcp = link(server.port());
  robot.silent = true;
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(tcp->waitForCycle(tcp->sensors().cycle + 100'000, stop));
  robot.silent = false;
  EXPECT_TRUE(stepOf(*tcp)) << tcp->whyEnded();
}

}  // namespace
}  // namespace darwinop::remote
