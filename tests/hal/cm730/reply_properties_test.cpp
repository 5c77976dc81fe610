// Properties of the answer to a BulkRead: who answers is read, who is silent is absent, in any pieces.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/conversions.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "hal/cm730/request_tag.hpp"

namespace darwinop::cm730 {
namespace {

struct AskedServo {
  ReadList::Entry entry;
  bool answers;
  std::uint16_t ticks;
};

/// Some servos in some order.
std::vector<AskedServo> anyServos() {
  std::vector<std::uint8_t> joints(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) joints[i] = static_cast<std::uint8_t>(i);
  for (std::size_t i = kJoints; i > 1; --i) std::swap(joints[i - 1], joints[*rc::gen::inRange<std::size_t>(0, i)]);
  std::vector<AskedServo> servos(*rc::gen::inRange<std::size_t>(0, kJoints + 1));
  for (std::size_t i = 0; i < servos.size(); ++i)
    servos[i] = {{joints[i], *rc::gen::arbitrary<bool>()},
                 *rc::gen::inRange(0, 4) > 0,
                 static_cast<std::uint16_t>(*rc::gen::inRange(0, kTickMax + 1))};
  return servos;
}

void append(std::vector<std::uint8_t>& stream, std::uint8_t id, const std::vector<std::uint8_t>& params) {
  std::array<std::uint8_t, kMaxFrame> room{};
  const auto frame = encodeStatus(room, id, 0, params);
  stream.insert(stream.end(), frame.begin(), frame.end());
}

std::vector<std::uint8_t> replyOf(const AskedServo& servo) {
  const RegisterWindow window = kServoWindows[servo.entry.poll];
  std::vector<std::uint8_t> params(window.count);
  const std::size_t at = servo::kPresentPosition - window.address;
  params[at] = lowByte(servo.ticks);
  params[at + 1] = highByte(servo.ticks);
  return params;
}

/// Feeds it in pieces of up to a hundred bytes.
void feedInPieces(ReplyDecoder& decoder, Bytes stream) {
  FrameReader reader;
  while (!stream.empty()) {
    const auto piece = std::min<std::size_t>(stream.size(), *rc::gen::inRange<std::size_t>(1, 101));
    stream = stream.subspan(reader.feed(stream.first(piece)));
    decoder.takeAll(reader);
  }
  decoder.takeAll(reader, false);
}

RC_GTEST_PROP(BulkReadAnswer, GivesThePositionOfEachServoThatAnswersAndNoOther, ()) {
  const std::vector<AskedServo> servos = anyServos();
  const auto board_bytes =
      static_cast<std::uint8_t>(*rc::gen::inRange<int>(kBoardWindow.count, RequestTag::kMostBytes + 1));
  const bool board_answers = *rc::gen::inRange(0, 10) > 0;
  std::vector<ReadList::Entry> list;
  std::vector<std::uint8_t> stream;
  if (board_answers) append(stream, kBoardId, std::vector<std::uint8_t>(board_bytes));
  for (const AskedServo& servo : servos) {
    list.push_back(servo.entry);
    if (servo.answers) append(stream, servoId(servo.entry.joint), replyOf(servo));
  }

  BusReadings readings{};
  readings.forget();
  ReplyDecoder decoder;
  decoder.begin(list, board_bytes, readings);
  feedInPieces(decoder, stream);

  RC_ASSERT(readings.board.answered == board_answers);
  std::size_t expected = 0;
  for (const AskedServo& servo : servos) {
    const ServoReading& reading = readings.servo[servo.entry.joint];
    const bool read = board_answers && servo.answers;
    expected += read ? 1 : 0;
    RC_ASSERT(reading.answered == read);
    RC_ASSERT(reading.polled == (read && servo.entry.poll));
    RC_ASSERT((read ? reading.position == radFromTicks(servo.ticks) : std::isnan(reading.position.value)));
  }
  RC_ASSERT(decoder.answered().count() == expected);
}

}  // namespace
}  // namespace darwinop::cm730
