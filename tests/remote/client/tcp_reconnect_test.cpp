// TcpLink while replies stay away, and after a lost connection.
#include <gmock/gmock.h>

#include "remote/client/messages.hpp"
#include "scripted_robot.hpp"
#include "tcp_link_fixture.hpp"

namespace darwinop::remote {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

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
