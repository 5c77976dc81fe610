// What counts as an answer, and what a late, damaged or foreign frame must not do.
#include "hal/cm730/reply_decoder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/conversions.hpp"

namespace darwinop::cm730 {
namespace {

using Entry = ReadList::Entry;

/// The board's block at rest: power on, gyro 512, accelerometer 512/512/640, 11.8 V (the manual's example).
std::vector<std::uint8_t> boardBlock(std::size_t bytes = 30) {
  std::vector<std::uint8_t> block{0x01, 0x00, 0xC0, 0x07, 0xC0, 0x07, 0x00, 0, 0, 0,    0,    0,    0,    0,    0x00,
                                  0x02, 0x00, 0x02, 0x00, 0x02, 0x00, 0x02, 0, 2, 0x80, 0x02, 0x76, 0x00, 0x02, 0x00};
  block.resize(bytes);
  return block;
}

std::vector<std::uint8_t> servoBlock(std::uint16_t ticks) {
  return {lowByte(ticks), highByte(ticks), 0, 0, 0, 0};
}

struct Decoder : ::testing::Test {
  std::array<Entry, 3> list{{{0, false}, {1, false}, {18, true}}};
  BusReadings readings{};
  ReplyDecoder decoder;
  void SetUp() override { decoder.begin(list, 30, readings); }
  void take(std::uint8_t id, const std::vector<std::uint8_t>& params, std::uint8_t error = 0) {
    decoder.take(Frame{id, error, params});
  }
};

TEST_F(Decoder, BoardAtRestReadsZeroRatesAndOneG) {
  take(200, boardBlock());
  ASSERT_TRUE(readings.board.answered);
  for (const RadPerSec rate : readings.board.gyro) EXPECT_EQ(rate.value, 0.0);
  EXPECT_EQ(readings.board.accelerometer[0].value, 0.0);
  EXPECT_NEAR(readings.board.accelerometer[2].value, 9.80665, 1e-9);
  EXPECT_NEAR(readings.board.voltage.value, 11.8, 1e-9);
  EXPECT_TRUE(readings.board.servo_power);
  EXPECT_EQ(readings.board.led_eye, 0x07C0);
}

TEST_F(Decoder, ServoAnswersInSiUnitsWithItsErrorByte) {
  take(200, boardBlock());
  take(1, {0xDC, 0x05, 0x0A, 0x04, 0xFF, 0x01}, 32);  // 1500 ticks, 10 counts clockwise, load 511 counter-clockwise
  const ServoReading& servo = readings.servo[0];
  ASSERT_TRUE(servo.answered);
  EXPECT_DOUBLE_EQ(servo.position.value, (1500 - 2048) * kRadPerTick);
  EXPECT_DOUBLE_EQ(servo.velocity.value, -10 * kRadPerSecPerCount);
  EXPECT_NEAR(servo.load, 0.5, 0.001);
  EXPECT_EQ(servo.error_bits, 32);
  EXPECT_FALSE(servo.polled);
}

TEST_F(Decoder, AMissingReplyIsAbsentNotZero) {
  take(200, boardBlock());
  EXPECT_FALSE(readings.servo[1].answered);
  EXPECT_TRUE(std::isnan(readings.servo[1].position.value));
  EXPECT_TRUE(std::isnan(readings.servo[1].load));
  EXPECT_FALSE(decoder.complete());
}

TEST_F(Decoder, TheRoundRobinPollReadsVoltageTemperatureAndTorque) {
  take(200, boardBlock());
  std::vector<std::uint8_t> look(20, 0);
  look[0] = 1;                       // 24 torque enable
  look[10] = 0xFF, look[11] = 0x03;  // 34 torque limit
  look[12] = 0x02, look[13] = 0x08;  // 36 position 2050
  look[18] = 121, look[19] = 47;     // 42 voltage, 43 temperature
  take(19, look);
  const ServoReading& servo = readings.servo[18];
  ASSERT_TRUE(servo.polled);
  EXPECT_TRUE(servo.torque_enabled);
  EXPECT_DOUBLE_EQ(servo.torque_limit.value, 2.5);
  EXPECT_DOUBLE_EQ(servo.position.value, 2 * kRadPerTick);
  EXPECT_NEAR(servo.voltage.value, 12.1, 1e-9);
  EXPECT_EQ(servo.temperature.value, 47);
  EXPECT_TRUE(decoder.complete());  // the two before it have lost their turn
}

TEST_F(Decoder, RepliesBeforeTheBoardsReplyAreIgnored) {
  take(1, servoBlock(1000));  // left over from the request before
  EXPECT_FALSE(readings.servo[0].answered);
  take(200, boardBlock(31));  // answers an earlier request, which asked for 31 bytes
  EXPECT_FALSE(readings.board.answered);
  take(1, servoBlock(1000));
  EXPECT_FALSE(readings.servo[0].answered);
  EXPECT_EQ(decoder.lateReplies(), 3U);
  take(200, boardBlock());
  take(1, servoBlock(2000));
  EXPECT_DOUBLE_EQ(readings.servo[0].position.value, (2000 - 2048) * kRadPerTick);
}

TEST_F(Decoder, AnAcknowledgementOfABoardWriteIsNotAReading) {
  take(200, {});
  EXPECT_FALSE(readings.board.answered);
  EXPECT_EQ(decoder.lateReplies(), 0U);
}

TEST_F(Decoder, ASecondCopyOfAFrameChangesNothing) {
  take(200, boardBlock());
  take(1, servoBlock(1000));
  take(1, servoBlock(3000));
  EXPECT_DOUBLE_EQ(readings.servo[0].position.value, (1000 - 2048) * kRadPerTick);
}

TEST_F(Decoder, FramesOfWrongLengthOrUnknownIdAreIgnored) {
  take(200, boardBlock());
  take(1, {1, 2});
  take(77, servoBlock(1000));
  take(1, servoBlock(5000));  // no position an MX-28 in joint mode can have
  EXPECT_TRUE(decoder.answered().none());
}

/// The answer to the list, with both servos that are not polled at `ticks`.
std::vector<std::uint8_t> answerWith(std::uint16_t ticks) {
  std::array<std::uint8_t, kMaxFrame> room{};
  std::vector<std::uint8_t> stream;
  const auto append = [&](std::uint8_t id, const std::vector<std::uint8_t>& params) {
    const auto frame = encodeStatus(room, id, 0, params);
    stream.insert(stream.end(), frame.begin(), frame.end());
  };
  append(200, boardBlock());
  append(1, servoBlock(ticks));
  append(2, servoBlock(ticks));
  append(19, std::vector<std::uint8_t>(20, 0));
  return stream;
}

struct OneByteWrong : Decoder {
  /// Readings that `stream` leads to and that are not those of servos at `ticks`.
  int wrongReadings(const std::vector<std::uint8_t>& stream, std::uint16_t ticks) {
    readings.forget();
    decoder.begin(list, 30, readings);
    FrameReader reader;
    reader.feed(stream);
    decoder.takeAll(reader);
    decoder.takeAll(reader, false);
    int wrong = 0;
    for (const std::size_t joint : {0U, 1U})
      if (readings.servo[joint].answered && readings.servo[joint].position != radFromTicks(ticks)) ++wrong;
    return wrong;
  }
};

// A servo that stands still sends the same bytes again: what is lost from two of its replies in the same place would
// give the same wrong position twice, and two readings that agree decide where a joint is when torque comes on.
TEST_F(OneByteWrong, ALostByteNeverGivesAnotherPosition) {
  for (std::uint16_t ticks = 0; ticks <= kTickMax; ++ticks) {
    const std::vector<std::uint8_t> whole = answerWith(ticks);
    ASSERT_EQ(wrongReadings(whole, ticks), 0);
    ASSERT_EQ(decoder.answered().count(), 3U);
    for (std::size_t at = 36; at < whole.size(); ++at) {
      std::vector<std::uint8_t> stream = whole;
      stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(at));
      ASSERT_EQ(wrongReadings(stream, ticks), 0) << ticks << " ticks without byte " << at;
    }
  }
}

TEST_F(OneByteWrong, AnAddedByteNeverGivesAnotherPosition) {
  for (const std::uint8_t added : std::initializer_list<std::uint8_t>{0x00, 0x01, 0x07, 0x7F, 0xFF})
    for (std::uint16_t ticks = 0; ticks <= kTickMax; ++ticks) {
      const std::vector<std::uint8_t> whole = answerWith(ticks);
      for (std::size_t at = 36; at < 60; ++at) {
        std::vector<std::uint8_t> stream = whole;
        stream.insert(stream.begin() + static_cast<std::ptrdiff_t>(at), added);
        ASSERT_EQ(wrongReadings(stream, ticks), 0) << ticks << " ticks, " << int{added} << " before byte " << at;
      }
    }
}

TEST_F(Decoder, ComputesTheExpectedLength) {
  EXPECT_EQ(decoder.nextFrameBytes(), 36U);
  take(200, boardBlock());
  EXPECT_EQ(decoder.nextFrameBytes(), 12U);
  take(2, servoBlock(1));
  EXPECT_EQ(decoder.nextFrameBytes(), 26U);
}

}  // namespace
}  // namespace darwinop::cm730
