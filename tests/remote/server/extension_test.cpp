// Extension of the 2013 protocol, server side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "remote/protocol/examples.hpp"
#include "remote/protocol/reply_reader.hpp"
#include "remote/protocol/request_writer.hpp"
#include "remote/server/messages.hpp"
#include "served.hpp"

namespace darwinop::remote {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

Request extendedRequest(const Extension& extension = {}) {
  Request request;
  request.extended = true;
  request.extension = extension;
  return request;
}

ByteList bytesToSend(const Request& request) {
  RequestBuffer buffer;
  const auto bytes = writeRequest(request, buffer);
  return {bytes.begin(), bytes.end()};
}

/// A client with the extension; ask() returns the reply, or nullopt if there is none yet.
class ExtendedClient : public TestClient {
 public:
  using TestClient::TestClient;
  std::optional<Reply> ask(const Request& request) {
    send(bytesToSend(request));
    return read(request);
  }
  std::optional<Reply> read(const Request& request) {
    const ByteList bytes = receive();
    std::ranges::copy(bytes, reader_.room().begin());
    reader_.filled(bytes.size());
    Reply reply;
    if (reader_.next(request, reply) != ReplyReader::Result::kReply) return std::nullopt;
    return reply;
  }

 private:
  ReplyReader reader_;
};

TEST(RemoteExtension, IsSerializedAsDocumented) {
  const Request request = extendedRequest({.until_cycle = 0x102030405,
                                           .fault_resets = 2,
                                           .picture = 7,
                                           .only_if_up = true,
                                           .end_of_session = true,
                                           .unattended = true});
  EXPECT_EQ(toHex(bytesToSend(request)), "57 18 00 58 02 11 0e 00 00 00 02 00 00 00 07 00 00 00 01 02 03 04 05 00");
}

TEST(RemoteExtension, OfAnotherVersionIsSkipped) {
  for (const char* hex : {"57 08 00 58 01 01 ff 00", "57 07 00 58 02 00 00", "57 08 00 58 02 01 ff 00"}) {
    const ByteList bytes = fromHex(hex);
    Request request;
    RequestIssues issues;
    readSections(std::span{bytes}.subspan(kRequestHead), request, issues);
    EXPECT_FALSE(request.extended) << hex;
    EXPECT_FALSE(issues.any()) << hex;
  }
}

TEST(RemoteExtension, ThatIsCutOffIsIgnored) {
  const ByteList whole = bytesToSend(extendedRequest({.end_of_session = true}));
  for (std::size_t size = kRequestHead + 1; size + 1 < whole.size(); ++size) {
    Request request;
    RequestIssues issues;
    readSections(std::span{whole}.subspan(kRequestHead, size - kRequestHead), request, issues);
    EXPECT_FALSE(request.extended) << size;
    EXPECT_TRUE(issues.cut_off) << size;
  }
}

TEST(RemoteExtension, ContainsTheSensorImage) {
  Served served;
  served.robot.seen.cycle = 77;
  served.robot.seen.board.buttons = 2;
  served.robot.seen.joint[3].temperature = Celsius{41};
  served.robot.seen.safety.state = State::kDriven;
  ExtendedClient client{served};
  const auto reply = client.ask(extendedRequest());
  ASSERT_TRUE(reply && reply->extension && reply->extension->seen);
  const Sensors& seen = *reply->extension->seen;
  EXPECT_EQ(seen.cycle, 77);
  EXPECT_EQ(seen.board.buttons, 2);
  EXPECT_EQ(seen.joint[3].temperature.value, 41);
  EXPECT_EQ(seen.safety.state, State::kDriven);
  EXPECT_TRUE(reply->extension->real_time);
}

TEST(RemoteExtension, HoldsTheReplyUntilTheCycleAndReportsTheHoldTime) {
  Served served;
  served.robot.seen.cycle = 10;
  ExtendedClient client{served};
  const Request request = extendedRequest({.until_cycle = 11});
  EXPECT_FALSE(client.ask(request)) << "the cycle has not run yet";
  EXPECT_EQ(served.robot.applied.size(), 1) << "commands are applied at once, and once";
  served.robot.seen.cycle = 11;
  served.pass(5ms);
  const auto reply = client.read(request);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->extension->held_us, 5000);
  EXPECT_EQ(served.robot.applied.size(), 1);
}

TEST(RemoteExtension, RepliesAfterAWhileIfTheLoopStandsStill) {
  Served served;
  ExtendedClient client{served};
  const Request request = extendedRequest({.until_cycle = 1});
  EXPECT_FALSE(client.ask(request));
  served.pass(400ms);
  EXPECT_TRUE(client.read(request));
}

TEST(RemoteExtension, RepliesAtOnceWithUnknownValues) {
  Served served;
  served.robot.seen.joint[5] = {};
  ExtendedClient client{served};
  const auto reply = client.ask(extendedRequest());
  ASSERT_TRUE(reply);
  EXPECT_FALSE(reply->extension->seen->joint[5].motion.ever());
}

TEST(RemoteExtension, SendsTheReasonBeforeItDisconnects) {
  Served served;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  served.robot.must_end = "the battery is empty";
  const auto reply = client.ask(extendedRequest());
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->extension->why_ended, "the battery is empty");
  EXPECT_TRUE(client.shownOut());
  served.robot.must_end.clear();
  served.robot.refusal = "another controller drives";
  ExtendedClient next{served};
  const auto refused = next.ask(extendedRequest());
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->extension->why_ended, "another controller drives");
}

TEST(RemoteExtension, AClientMayFinishItsStepsWhenTheRobotEnds) {
  Served served;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  served.robot.end_request = "the runtime ends";
  for (int step = 0; step < 3; ++step) {
    const auto reply = client.ask(extendedRequest());
    ASSERT_TRUE(reply && reply->extension->seen);
    EXPECT_EQ(reply->extension->why_ended, "the runtime ends");
  }
  EXPECT_EQ(served.robot.applied.size(), 4);
  EXPECT_TRUE(client.ask(extendedRequest({.end_of_session = true})));
  EXPECT_THAT(served.robot.events, ElementsAre("new", "end"));

  ExtendedClient next{served};
  const auto refused = next.ask(extendedRequest());
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->extension->seen, nullptr) << "no session starts any more";
  EXPECT_EQ(refused->extension->why_ended, "the runtime ends");
  EXPECT_TRUE(next.shownOut());
}

TEST(RemoteExtension, AClientOf2013IsDisconnectedWhenTheRobotEnds) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  served.robot.end_request = "the runtime ends";
  client.send(kNeckRequest);
  EXPECT_TRUE(client.shownOut());
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold"));
}

TEST(RemoteExtension, AServerThatEndsLetsItsClientFinishItsSteps) {
  Served served;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  const std::atomic<bool> stop{true};
  int steps = 0;
  served.robot.on_apply = [&] {
    EXPECT_TRUE(steps == 0 || client.receive().size() > std::string_view{messages::kServerEnds}.size());
    client.sendOnly(bytesToSend(extendedRequest({.end_of_session = ++steps == 3})));
  };
  client.sendOnly(bytesToSend(extendedRequest()));
  served.server.run(stop);
  EXPECT_EQ(steps, 4);
  EXPECT_THAT(served.robot.events, ElementsAre("new", "end"));
}

TEST(RemoteExtension, AServerThatEndsWaitsForItsClientForThreeSeconds) {
  Served served;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  const Nanos begun = served.now;
  served.robot.on_apply = [&] {
    served.now += 400ms;
    (void)client.receive();
    client.sendOnly(bytesToSend(extendedRequest()));
  };
  client.sendOnly(bytesToSend(extendedRequest()));
  served.server.run(std::atomic<bool>{true});
  EXPECT_LE(served.now - begun, 3400ms);
  EXPECT_GE(served.now - begun, 3000ms);
}

TEST(RemoteExtension, AResumedSessionDoesNotStartARobotWhoseTorqueIsOff) {
  Served served;
  served.robot.seen.safety.state = State::kHolding;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  served.pass(600ms);
  const Request goes_on = extendedRequest({.only_if_up = true});
  EXPECT_TRUE(client.ask(goes_on)->extension->why_ended.empty()) << "it is held, and may be driven on";
  served.pass(600ms);
  served.robot.seen.safety.state = State::kLimp;  // released with MODE
  EXPECT_EQ(client.ask(goes_on)->extension->why_ended, messages::kTorqueSwitchedOff);
  EXPECT_TRUE(client.shownOut());
  EXPECT_THAT(served.robot.events, ElementsAre("new", "hold", "resumed", "hold", "resumed", "left alone"));
  ExtendedClient back{served};
  EXPECT_EQ(back.ask(goes_on)->extension->why_ended, messages::kTorqueSwitchedOff);
  SafetyReport& safety = served.robot.seen.safety;
  safety.state = State::kKneeling;
  safety.worst = Fault::kServoOverload;
  safety.controller_must_end = true;
  ExtendedClient overloaded{served};
  EXPECT_THAT(overloaded.ask(goes_on)->extension->why_ended, HasSubstr(std::string{row(Fault::kServoOverload).meaning}))
      << "a new driver would clear it";
  ExtendedClient next{served};
  EXPECT_TRUE(next.ask(extendedRequest())->extension->why_ended.empty()) << "a new controller may drive";
}

TEST(RemoteExtension, APausedClientOf2013DoesNotClearTheFaultThatEndedIt) {
  Served served;
  TestClient paused{served};
  (void)paused.ask("57 04 00 00");
  served.pass(600ms);
  served.robot.seen.safety.state = State::kLimp;  // at rest: a paused simulation continues
  EXPECT_NE(paused.ask("57 04 00 00"), "");
  served.pass(600ms);
  served.robot.seen.safety.worst = Fault::kReleasedByButton;
  served.robot.seen.safety.controller_must_end = true;
  EXPECT_EQ(paused.ask("57 04 00 00"), "");
  EXPECT_TRUE(served.hasSaid(std::string{row(Fault::kReleasedByButton).meaning}));
}

TEST(RemoteExtension, EndOfSessionEndsInsteadOfHolding) {
  Served served;
  ExtendedClient client{served};
  (void)client.ask(extendedRequest());
  EXPECT_TRUE(client.ask(extendedRequest({.end_of_session = true})));
  EXPECT_THAT(served.robot.events, ElementsAre("new", "end"));
  EXPECT_TRUE(client.shownOut());
  EXPECT_TRUE(ExtendedClient{served}.connected()) << "the next client is accepted";
}

TEST(RemoteExtension, APictureIsSentOnce) {
  struct Newest final : PictureSource {
    ByteList jpeg{1, 2, 3};
    JpegPicture newest() override { return {.sequence = 9, .age = 20ms, .jpeg = jpeg}; }
  };
  Served served{[] { return std::make_unique<Newest>(); }};
  ExtendedClient client{served};
  Request request = extendedRequest();
  request.camera = true;
  const auto first = client.ask(request);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->jpeg.size(), 3);
  EXPECT_EQ(first->extension->picture, 9);
  EXPECT_EQ(first->extension->picture_age_us, 20000);
  request.extension.picture = 9;
  const auto second = client.ask(request);
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->jpeg.empty());
  EXPECT_TRUE(second->extension->holds_picture);
}

TEST(RemoteExtension, ThePictureOfARobotWithoutACameraIsAbsent) {
  ServerConfig config = Served::unhurried();
  config.no_picture = {1, 2, 3};
  Served served{{}, config};
  ExtendedClient client{served};
  Request request = extendedRequest();
  request.camera = true;
  const auto reply = client.ask(request);
  ASSERT_TRUE(reply);
  EXPECT_TRUE(reply->jpeg.empty()) << "a client that reads the extension reports a missing camera";
  EXPECT_EQ(reply->extension->picture, 0);
}

TEST(RemoteExtension, IsSentOnlyOnRequest) {
  Served served;
  TestClient client{served};
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
}

}  // namespace
}  // namespace darwinop::remote
