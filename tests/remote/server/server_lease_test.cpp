// Lease of the server: driving, silent and disconnecting clients.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "remote/server/messages.hpp"
#include "remote/server/server.hpp"
#include "visits.hpp"

namespace darwinop::remote {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;

TEST(RemoteServer, RefusesASecondClient) {
  Served served;
  TestClient first{served};
  (void)first.ask(kEmptyRequest);
  TestClient second{served};
  EXPECT_FALSE(second.connected());
  EXPECT_EQ(first.ask(kEmptyRequest), kEmptyReply);
  EXPECT_TRUE(served.hasSaid(messages::kDrives));
}

TEST(RemoteServer, HoldsWhenAClientDisconnectsAndAcceptsTheNext) {
  Served served;
  for (const bool rudely : {false, true}) {
    TestClient client{served};
    EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
    rudely ? client.reset() : client.close();
    EXPECT_FALSE(served.robot.driven);
  }
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold", "new", "hold"));
}

TEST(RemoteServer, SurvivesADisconnectAtEveryByte) {
  Served served;
  const ByteList bytes = fromHex(std::string{kSixRequest} + " " + kPollRequest);
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    TestClient client{served};
    ASSERT_TRUE(client.connected()) << size;
    client.send(ByteList(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    size % 2 == 0 ? client.close() : client.reset();
    EXPECT_FALSE(served.robot.driven) << size;
  }
  EXPECT_TRUE(nextIsAnswered(served));
}

TEST(RemoteServer, HoldsTheRobotOfASilentClientThatMayResume) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  served.pass(499ms);
  EXPECT_TRUE(served.robot.driven);
  served.pass(1ms);
  EXPECT_FALSE(served.robot.driven);
  served.pass(60s);  // a simulation may pause for any time
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold", "resumed"));
  TestClient late{served};
  EXPECT_FALSE(late.connected()) << "it drives again";
}

TEST(RemoteServer, CountsSilenceFromTheEndOfItsOwnWork) {
  Served served;
  served.robot.on_apply = [&] { served.now += 700ms; };  // a simulation on a busy machine
  TestClient client{served};
  for (int request = 0; request < 3; ++request) EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
  served.pass(499ms);
  EXPECT_THAT(served.robot.events, ElementsAre("new")) << "the client waited for the server";
  served.pass(1ms);
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold"));
}

TEST(RemoteServer, ReplacesASilentClientByTheNext) {
  Served served;
  TestClient silent{served};
  (void)silent.ask(kEmptyRequest);
  served.pass(500ms);
  TestClient next{served};
  EXPECT_EQ(next.ask(kEmptyRequest), kEmptyReply);
  EXPECT_TRUE(silent.shownOut());
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold", "new"));
}

TEST(RemoteServer, CountsAnIncompleteRequestAsSilence) {
  Served served;
  TestClient slow{served};
  (void)slow.ask(kEmptyRequest);
  for (const std::uint8_t byte : fromHex("57 2f 00 41 47 43")) {
    slow.send(ByteList{byte});
    served.pass(100ms);
  }
  EXPECT_FALSE(served.robot.driven) << "bytes came all the time, and no request";
  EXPECT_TRUE(nextIsAnswered(served));
}

TEST(RemoteServer, DisconnectsAClientIfTheLeaseIsTaken) {
  Served served;
  served.robot.refusal = "another controller (pid 7) drives this robot";
  TestClient client{served};
  client.send(kEmptyRequest);
  EXPECT_TRUE(client.shownOut());
  EXPECT_TRUE(served.hasSaid("another controller (pid 7)"));
}

TEST(RemoteServer, EndsASessionWhenAControllerWouldHaveToEnd) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  served.robot.must_end = "torque was switched off by the button";
  client.send(kNeckRequest);
  EXPECT_TRUE(client.shownOut());
  EXPECT_EQ(served.robot.applied.size(), 1) << "its command came too late";
  EXPECT_FALSE(served.robot.driven);
}

}  // namespace
}  // namespace darwinop::remote
