// Every protocol example, in both directions.
#include <gtest/gtest.h>

#include "examples.hpp"
#include "remote/protocol/reply.hpp"
#include "remote/protocol/request_reader.hpp"
#include "remote/protocol/request_writer.hpp"
#include "support/hex.hpp"

namespace darwinop::remote {
namespace {

std::string bytesOf(const Request& request) {
  RequestBuffer buffer;
  return toHex(writeRequest(request, buffer));
}

Request requestOf(const std::string& hex) {
  const std::vector<std::uint8_t> bytes = fromHex(hex);
  Request request;
  RequestIssues issues;
  readSections(std::span{bytes}.subspan(kRequestHead), request, issues);
  EXPECT_FALSE(issues.any()) << hex;
  return request;
}

void expectExchange(const Request& request, const std::string& hex) {
  EXPECT_EQ(bytesOf(request), hex);
  EXPECT_EQ(requestOf(hex), request) << hex;
}

std::string replyTo(const Request& request, const Reply& reply) {
  std::vector<std::uint8_t> bytes;
  writeReply(request, reply, bytes);
  return toHex(bytes);
}

TEST(RemoteExample, AnEmptyRequestGetsAnEmptyReply) {
  expectExchange({}, kEmptyRequest);
  EXPECT_EQ(replyTo({}, {}), kEmptyReply);
}

TEST(RemoteExample, InertialSensorsAreCounts) {
  Request request;
  request.accelerometer = request.gyro = true;
  expectExchange(request, kInertialRequest);
  Reply reply;
  reply.accelerometer = {512, 498, 640};
  reply.gyro = {511, 512, 513};
  EXPECT_EQ(replyTo(request, reply), kInertialReply);
}

TEST(RemoteExample, AGoalIsCutTowardsTheCentre) {
  expectExchange(
      requestForMotor({.joint = Joint::kNeck, .set = MotorSetting::kPosition, .position = wireFromPosition(0.5)}),
      kNeckRequest);
  EXPECT_NEAR(positionFromWire(325), 0.49854, 5e-6);
}

TEST(RemoteExample, GoalAndVelocityOfOneMotor) {
  expectExchange(requestForMotor({.joint = Joint::kHead,
                                  .set = MotorSetting::kPosition | MotorSetting::kVelocity,
                                  .position = wireFromPosition(-0.25),
                                  .velocity = wireFromVelocity(2)}),
                 kHeadRequest);
}

TEST(RemoteExample, AllSettingsOfAMotor) {
  expectExchange(requestForMotor({.joint = Joint::kArmUpperR,
                                  .set = 63,
                                  .position = wireFromPosition(-1),
                                  .velocity = wireFromVelocity(1.5),
                                  .acceleration = 350000,
                                  .available_torque = cut(1.25 * kTorqueMax / kMaxTorqueNm),
                                  .torque = cut(0.5 * kTorqueMax / kMaxTorqueNm),
                                  .pid = {10000, 0, 0}}),
                 kSixRequest);
  EXPECT_EQ(accelerationFromWire(350000), 3.5);
  EXPECT_EQ(accelerationFromWire(50000), 0.5) << "0 would be no ramp: the most violent motion of all";
  EXPECT_EQ(gainFromWire(10000), 10);
}

TEST(RemoteExample, AnAccelerationOfMinusOneRemovesTheRamp) {
  expectExchange(
      requestForMotor({.joint = Joint::kArmUpperR, .set = MotorSetting::kAcceleration, .acceleration = -100000}),
      kNoRampRequest);
  EXPECT_EQ(accelerationFromWire(-100000), -1);
}

TEST(RemoteExample, Leds) {
  Request request;
  (void)request.leds.add({Led::kEye, 0xFF0000});
  (void)request.leds.add({Led::kBackRed, 1});
  expectExchange(request, kLedRequest);
}

TEST(RemoteExample, PositionsAndTorquesAreInTheOrderOfTheRequest) {
  Request request;
  (void)request.positions.add(18);
  (void)request.positions.add(19);
  (void)request.torques.add(18);
  expectExchange(request, kFeedbackRequest);
  Reply reply;
  (void)reply.positions.add(wireFromMeasuredPosition(0.00307));
  (void)reply.positions.add(wireFromMeasuredPosition(0.191995));
  (void)reply.torques.add(wireFromMeasuredTorque(0.18817));
  EXPECT_EQ(replyTo(request, reply), kFeedbackReply);
}

TEST(RemoteExample, APictureCarriesItsLength) {
  Request request;
  request.camera = true;
  expectExchange(request, kCameraRequest);
  const std::vector<std::uint8_t> jpeg = fromHex("ff d8 ff e0 00 10 ff d9");
  Reply reply;
  reply.jpeg = jpeg;
  EXPECT_EQ(replyTo(request, reply), kCameraReply);
}

TEST(RemoteExample, EverythingAtOnce) {
  Request request;
  request.accelerometer = request.gyro = request.camera = true;
  Reply reply;
  for (std::uint8_t joint = 0; joint < kJoints; ++joint) {
    (void)request.positions.add(joint);
    (void)reply.positions.add(joint);
  }
  expectExchange(request, kPollRequest);
  const std::vector<std::uint8_t> jpeg(1000, 7);
  reply.jpeg = jpeg;
  const std::vector<std::uint8_t> bytes = fromHex(replyTo(request, reply));
  EXPECT_EQ(bytes.size(), 113 + jpeg.size() + 1);
  EXPECT_EQ(toHex(std::span{bytes}.first(5)), "57 00 00 04 59") << "113 + 1000, without the NUL";
}

TEST(RemoteUnits, UnknownValuesAreNan) {
  EXPECT_EQ(wireFromMeasuredPosition(std::numeric_limits<double>::quiet_NaN()), kNoValue);
  EXPECT_TRUE(std::isnan(measuredFromWire(kNoValue)));
  EXPECT_EQ(measuredFromWire(-1919), -0.1919);
  EXPECT_EQ(wireFromPosition(std::numeric_limits<double>::infinity()), kNoValue);
  EXPECT_FALSE(isEncoderPosition(kNoValue));
  EXPECT_TRUE(isEncoderPosition(-2048));
  EXPECT_FALSE(isEncoderPosition(2048));
}

}  // namespace
}  // namespace darwinop::remote
