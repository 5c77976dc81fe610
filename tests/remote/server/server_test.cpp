// The server on loopback sockets, with a scripted clock.
#include "remote/server/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fixed_eye.hpp"
#include "remote/protocol/examples.hpp"
#include "remote/server/messages.hpp"
#include "served.hpp"

namespace darwinop::remote {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;

TEST(RemoteServer, AnswersTheFirstRequestAtOnce) {
  Served served;
  TestClient client{served};
  EXPECT_TRUE(served.robot.events.empty()) << "a connection alone moves nothing";
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
  EXPECT_THAT(served.robot.events, ElementsAre("new"));
}

TEST(RemoteServer, CommandsReachTheRobotAndValuesTheClient) {
  Served served;
  TestClient client{served};
  served.robot.seen.joint[18].position = Rad{0.00307};
  served.robot.seen.joint[19].position = Rad{0.191995};
  served.robot.seen.joint[18].load = -0.18817 / 2.5;
  EXPECT_EQ(client.ask(kFeedbackRequest), kFeedbackReply);
  EXPECT_EQ(client.ask(kNeckRequest), kEmptyReply);
  ASSERT_EQ(served.robot.applied.size(), 2);
  EXPECT_EQ(served.robot.applied[1].motors[0].position, 325);
}

TEST(RemoteServer, SensorsOfTheBoardAreCounts) {
  Served served;
  TestClient client{served};
  EXPECT_EQ(client.ask(kInertialRequest),
            "57 00 00 00 1d 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00");
}

TEST(RemoteServer, SendsReplyAndNulTogether) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served};
  EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
}

TEST(RemoteServer, SendsTheConfiguredPictureIfThereIsNoCamera) {
  ServerConfig config = Served::unhurried();
  config.no_picture = FixedEye{}.jpeg;
  Served served{{}, config};
  TestClient client{served};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
  EXPECT_EQ(std::ranges::count_if(served.said,
                                  [](auto& line) { return line.find(messages::kNoPictures) != std::string::npos; }),
            1);
}

TEST(RemoteServer, LogsOnceThatTheCameraCannotBeOpened) {
  Served served{[]() -> std::unique_ptr<PictureSource> { throw std::runtime_error("this one is blind"); }};
  TestClient client{served};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), "57 00 00 00 09 00 00 00 00 00");
  EXPECT_TRUE(served.hasSaid("this one is blind"));
}

TEST(RemoteServer, OpensTheCameraWhileAClientDrivesThatRequestsPictures) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  EXPECT_EQ(eye.open, 0) << "it does not look";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
  EXPECT_EQ(eye.opened, 1);
  served.pass(500ms);
  EXPECT_EQ(eye.open, 0) << "no encoding for a silent client";
  EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
  client.close();
  EXPECT_EQ(eye.open, 0);
  EXPECT_EQ(eye.opened, 2);
}

TEST(RemoteServer, AnswersEveryRequestHoweverItIsFragmented) {
  Served served;
  TestClient client{served};
  std::size_t rounds = 0;
  for (const char* const example : kRequests) {
    const ByteList bytes = fromHex(example);
    for (std::size_t cut = 1; cut < bytes.size(); ++cut, ++rounds) {
      client.send(ByteList(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(cut)));
      EXPECT_TRUE(client.receive().empty()) << example << " answered after " << cut << " bytes";
      client.send(ByteList(bytes.begin() + static_cast<std::ptrdiff_t>(cut), bytes.end()));
      const ByteList reply = client.receive();
      ASSERT_FALSE(reply.empty()) << example << " cut at " << cut;
      EXPECT_EQ(reply.size(), statedSize(reply));
    }
  }
  EXPECT_EQ(served.robot.applied.size(), rounds);
}

TEST(RemoteServer, AnswersTwoRequestsInOneSegment) {
  Served served;
  TestClient client{served};
  EXPECT_EQ(client.ask(std::string{kNeckRequest} + " " + kEmptyRequest), std::string{kEmptyReply} + " " + kEmptyReply);
}

TEST(RemoteServer, BothClientsOf2013ReadTheirReplies) {
  FixedEye eye;
  eye.jpeg.assign(20000, 0x57);  // 'W' inside a picture must not be taken for the start of a reply
  Served served{eye.opener()};
  for (const auto read : {readAsIn2013, readAsToday}) {
    TestClient client{served};
    for (int round = 0; round < 5; ++round) {
      client.send(round % 2 == 0 ? kPollRequest : kFeedbackRequest);
      ASSERT_FALSE(read(client).empty()) << round;
    }
    client.close();
  }
}

// Alone in a segment, the NUL could arrive after the rest was read and be taken for the start of the next reply.
TEST(RemoteServer, NeverSendsTheNulAloneInASegment) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served, 1000};
  std::vector<std::size_t> without;
  for (std::size_t size = 1; size < 3200; ++size) {
    eye.jpeg.assign(size, 0x57);
    client.send(kCameraRequest);
    const ByteList reply = readAsIn2013(client);
    ASSERT_FALSE(reply.empty()) << size;
    if (reply.size() != statedSize(reply)) without.push_back(reply.size());
  }
  ASSERT_GE(without.size(), 3) << "packets of 1000 bytes or less";
  EXPECT_LE(without[0], 1000);
  for (std::size_t i = 0; i < without.size(); ++i) EXPECT_EQ(without[i], (i + 1) * without[0]) << "whole packets";
}

TEST(RemoteServer, WaitsForTheFirstValuesOfServosThatWereWithoutPower) {
  Served served;
  const JointSensors neck = std::exchange(served.robot.seen.joint[18], JointSensors{});
  TestClient client{served};
  EXPECT_EQ(client.ask(std::string{kEmptyRequest}), kEmptyReply) << "nothing of the neck was asked";
  EXPECT_EQ(client.ask("57 06 00 50 12 00"), "");
  served.pass(1s);
  EXPECT_TRUE(served.robot.driven) << "waiting is not silence";
  served.robot.seen.joint[18] = neck;
  served.poll();
  EXPECT_EQ(toHex(client.receive()), "57 00 00 00 09 00 00 00 b4 00");
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
}

TEST(RemoteServer, SurvivesADisconnectWhileAReplyWaits) {
  Served served;
  served.robot.seen.joint[18] = JointSensors{};
  TestClient client{served};
  EXPECT_EQ(client.ask("57 06 00 50 12 00"), "");
  client.reset();
  EXPECT_FALSE(served.robot.driven);
}

TEST(RemoteServer, LogsUnknownAndStaleValues) {
  Served served;
  served.robot.seen.joint[18] = JointSensors{};
  served.robot.seen.joint[19].motion.age = 4;
  TestClient client{served};
  EXPECT_EQ(client.ask("57 08 00 50 12 50 13 00"), "");
  served.pass(2s);
  EXPECT_EQ(toHex(client.receive()), "57 00 00 00 0d 80 00 00 00 00 00 00 be 00");
  EXPECT_EQ(client.ask("57 08 00 50 12 50 13 00"), "57 00 00 00 0d 80 00 00 00 00 00 00 be 00")
      << "at once from now on";
  EXPECT_TRUE(served.hasSaid("Neck" + std::string{messages::kNeverAnswered}));
  EXPECT_TRUE(served.hasSaid("Head" + std::string{messages::kAnsweredLongAgo}));
}

}  // namespace
}  // namespace darwinop::remote
