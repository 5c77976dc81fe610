// Parts of the client: commands to requests, pictures, network speed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "remote/client/command_delta.hpp"
#include "remote/client/link_speed.hpp"
#include "remote/client/messages.hpp"
#include "remote/client/pictures.hpp"
#include "remote/jpeg/encoder.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {
namespace {

using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

Request changesFrom(CommandDelta& delta, const Commands& wanted) {
  Request request;
  delta.add(wanted, request);
  return request;
}

TEST(RemoteCommandDelta, SendsTheSameTickAsWithoutANetwork) {
  for (int tick = 0; tick < 4096; tick += 5) {
    CommandDelta delta;
    Commands wanted;
    wanted.joint[3].setGoal(radFromTicks(tick));
    const Request request = changesFrom(delta, wanted);
    ASSERT_EQ(request.motors.size(), 1);
    EXPECT_EQ(ticksFromRad(Rad{positionFromWire(request.motors[0].position)}), tick);
  }
}

TEST(RemoteCommandDelta, ClampsGoalsToTheEncodersRange) {
  CommandDelta delta;
  Commands wanted;
  wanted.joint[3].setGoal(Rad{5});
  EXPECT_EQ(changesFrom(delta, wanted).motors[0].position, 2047)
      << "the server ignores values outside the encoder's range";
}

TEST(RemoteCommandDelta, ClampsSpeedAndGainAsSafetyDoes) {
  CommandDelta delta;
  Commands wanted;
  wanted.joint[3].setSpeedLimit(RadPerSec{1e9});
  wanted.joint[3].setPGain(1e9);
  const Request request = changesFrom(delta, wanted);
  ASSERT_EQ(request.motors.size(), 1);
  EXPECT_TRUE(request.motors[0].has(MotorSetting::kVelocity));
  EXPECT_EQ(request.motors[0].velocity, 1023);
  EXPECT_EQ(request.motors[0].pid[0], 31750);
}

TEST(RemoteCommandDelta, IgnoresNan) {
  CommandDelta delta;
  Commands wanted;
  wanted.joint[3].setGoal(Rad{});
  wanted.joint[3].setTorque(true);
  wanted.joint[3].setTorqueLimit(NewtonMeter{});
  EXPECT_TRUE(changesFrom(delta, wanted).motors.empty()) << "torque stays on";
}

TEST(RemoteCommandDelta, SwitchesTorqueOffOnlyAtZero) {
  CommandDelta delta;
  Commands wanted;
  wanted.joint[3].setTorque(true);
  wanted.joint[3].setTorqueLimit(NewtonMeter{0.0001});
  EXPECT_EQ(changesFrom(delta, wanted).motors[0].available_torque, 1);
  wanted.joint[3].setTorque(false);
  const Request limp = changesFrom(delta, wanted);
  ASSERT_EQ(limp.motors.size(), 1);
  EXPECT_EQ(limp.motors[0].set, MotorSetting::kAvailableTorque);
  EXPECT_EQ(limp.motors[0].available_torque, 0);
}

TEST(RemoteCommandDelta, SendsEachBackLedOnItsOwn) {
  CommandDelta delta;
  Commands wanted;
  wanted.led.setPanel(1 | 4);
  const Request request = changesFrom(delta, wanted);
  ASSERT_EQ(request.leds.size(), 3);
  EXPECT_EQ(request.leds[0], (LedSetting{Led::kBackRed, 1}));
  EXPECT_EQ(request.leds[1], (LedSetting{Led::kBackGreen, 1}));
  EXPECT_EQ(request.leds[2], (LedSetting{Led::kBackBlue, 0}));
  EXPECT_TRUE(changesFrom(delta, wanted).leds.empty());
}

/// A reply with a grey picture of this size.
std::vector<std::uint8_t> greyJpeg(ImageSize size) {
  const std::vector<std::uint8_t> grey(std::size_t{4} * kWholeImage.width * kWholeImage.height, 128);
  JpegEncoder encoder{size, qualityOf(size)};
  std::vector<std::uint8_t> jpeg(encoder.mostBytes());
  jpeg.resize(
      encoder.encode({.sequence = 1, .width = kWholeImage.width, .height = kWholeImage.height, .bgra = grey}, jpeg));
  return jpeg;
}

class RemotePictures : public testing::Test {
 protected:
  void comes(const std::vector<std::uint8_t>& jpeg, std::uint32_t number) {
    Reply reply;
    reply.jpeg = jpeg;
    reply.extension = ReplyExtension{.picture = number};
    pictures.take(reply, now);
  }
  Nanos now{1h};
  std::string said;
  Pictures pictures{[this](const std::string& what) { said += what; }};
  std::unique_ptr<FrameSource> eyes = pictures.open([this] { return now; });
};

TEST_F(RemotePictures, AreSeen) {
  EXPECT_EQ(eyes->newest().sequence, 0);
  comes(greyJpeg(kWholeImage), 9);
  const CameraFrame frame = eyes->newest();
  EXPECT_EQ(frame.width, 320);
  EXPECT_NEAR(frame.bgra[4 * 12345], 128, 3);
  EXPECT_EQ(frame.bgra[3], 255);
  EXPECT_TRUE(eyes->health().seeing);
  EXPECT_EQ(pictures.held(), 9);
  EXPECT_EQ(said, "");
}

TEST_F(RemotePictures, OfASmallerSizeAreCentred) {
  comes(greyJpeg({80, 60}), 1);
  const CameraFrame frame = eyes->newest();
  const auto at = [&](int column, int row) { return frame.bgra[4 * static_cast<std::size_t>(row * 320 + column)]; };
  EXPECT_EQ(frame.width, 320);
  EXPECT_NEAR(at(120, 90), 128, 3);
  EXPECT_NEAR(at(199, 149), 128, 3);
  EXPECT_EQ(at(119, 90), 0);
  EXPECT_EQ(at(200, 149), 0);
  EXPECT_THAT(said, HasSubstr("middle 80x60"));
}

TEST_F(RemotePictures, ThatAreDamagedOrBlackOrOldAreDiscarded) {
  comes({1, 2, 3}, 1);
  EXPECT_EQ(eyes->newest().sequence, 0);
  EXPECT_EQ(eyes->health().damaged, 1);
  comes(greyJpeg(kWholeImage), 0);
  (void)eyes->newest();
  EXPECT_FALSE(eyes->health().seeing) << "picture number 0 means that the camera is blind";
  comes(greyJpeg(kWholeImage), 2);
  (void)eyes->newest();
  EXPECT_TRUE(eyes->health().seeing);
  now += 3s;
  EXPECT_FALSE(eyes->health().seeing) << "while no newer picture arrives";
}

TEST_F(RemotePictures, OfABlindCameraAreLogged) {
  for (int i = 0; i < 50; ++i, now += 100ms) comes(greyJpeg({40, 30}), 0);
  EXPECT_EQ(said, messages::kRobotsCameraIsBlind) << "once";
}

TEST_F(RemotePictures, AreRequestedJustBeforeTheyAreAccessed) {
  (void)eyes->newest();
  std::string asked;
  for (int step = 0; step < 13; ++step) {
    const bool due = pictures.areDue();
    asked += due ? 'P' : '.';
    if (due) comes(greyJpeg({40, 30}), static_cast<std::uint32_t>(step) + 1);
    if (step % 4 == 3) (void)eyes->newest();
  }
  EXPECT_EQ(asked, "P......P...P.") << "it learns that the camera is looked at every fourth step";
  eyes.reset();
  EXPECT_FALSE(pictures.areDue()) << "not accessed";
}

std::string judged(LinkSpeed& speed, Nanos network, std::size_t picture, ImageSize size) {
  std::string said;
  for (int i = 0; i < 400; ++i) {
    const bool with = picture > 0 && i % 2 == 0;
    said += speed.note({.network = with || picture == 0 ? network : 4ms,
                        .step = 16ms,
                        .picture = with ? picture : 0,
                        .size = with ? std::optional{size} : std::nullopt});
    if (picture > 0 && with) said += speed.note({.network = network, .step = 16ms, .picture = picture, .size = size});
  }
  return said;
}

TEST(RemoteLinkSpeed, LogsNothingWhileTheNetworkIsFastEnough) {
  LinkSpeed speed;
  EXPECT_EQ(judged(speed, 12ms, 11000, kWholeImage), "");
}

TEST(RemoteLinkSpeed, LogsThePictureSizeThatWouldFit) {
  LinkSpeed speed;
  const std::string said = judged(speed, 24ms, 11000, kWholeImage);
  EXPECT_THAT(said, HasSubstr(" 24 ms"));
  EXPECT_THAT(said, HasSubstr(" 20 ms"));
  EXPECT_THAT(said, HasSubstr("11000 bytes"));
  EXPECT_THAT(said, HasSubstr("160x120" + std::string{messages::kSizeFits} + "2 2"));
  EXPECT_EQ(said.find(messages::kNetworkTooSlow), said.rfind(messages::kNetworkTooSlow)) << "once";
}

TEST(RemoteLinkSpeed, SuggestsNoSizeWithoutPictures) {
  LinkSpeed speed;
  EXPECT_THAT(judged(speed, 40ms, 0, kWholeImage),
              testing::AllOf(HasSubstr(messages::kNetworkTooSlow), Not(HasSubstr(messages::kSizeFits))));
}

}  // namespace
}  // namespace darwinop::remote
