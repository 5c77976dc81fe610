// Reply parser: round trip, fragmented, concatenated and invalid input.
#include "remote/protocol/reply_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "any_image.hpp"
#include "remote/protocol/sensor_block.hpp"

namespace darwinop::remote {
namespace {

using ReplyList = std::vector<std::uint8_t>;

/// Feeds `bytes` in pieces of `size` and returns the result; `reader` owns the data that the reply points to.
ReplyReader::Result readReplyInPieces(ReplyReader& reader, std::span<const std::uint8_t> bytes, const Request& asked,
                                      Reply& reply, std::size_t size) {
  ReplyReader::Result found = ReplyReader::Result::kIncomplete;
  while (!bytes.empty() && found == ReplyReader::Result::kIncomplete) {
    const std::span<std::uint8_t> room = reader.room();
    const std::size_t count = std::min({size, bytes.size(), room.size()});
    if (count == 0) return ReplyReader::Result::kInvalid;  // a drained reader always has room
    std::ranges::copy(bytes.first(count), room.begin());
    reader.filled(count);
    bytes = bytes.subspan(count);
    found = reader.next(asked, reply);
  }
  return found;
}

ReplyList written(const Request& request, const Reply& reply) {
  ReplyList bytes;
  writeReply(request, reply, bytes);
  return bytes;
}

ReplyList blockOf(const Sensors& seen) {
  ReplyList bytes;
  writeSensors(seen, bytes);
  return bytes;
}

Request anyQuestion() {
  Request asked;
  asked.accelerometer = *rc::gen::arbitrary<bool>();
  asked.gyro = *rc::gen::arbitrary<bool>();
  asked.camera = *rc::gen::arbitrary<bool>();
  asked.extended = *rc::gen::arbitrary<bool>();
  const int positions = *rc::gen::inRange(0, 21), torques = *rc::gen::inRange(0, 21);
  for (int i = 0; i < positions; ++i) (void)asked.positions.add(1);
  for (int i = 0; i < torques; ++i) (void)asked.torques.add(2);
  return asked;
}

RC_GTEST_PROP(ReplyReader, ReadsWhatWasWrittenHoweverItIsCut, ()) {
  const Request asked = anyQuestion();
  const auto word = [] { return *rc::gen::arbitrary<std::int32_t>(); };
  Reply reply;
  if (asked.accelerometer) reply.accelerometer = {word(), word(), word()};
  if (asked.gyro) reply.gyro = {word(), word(), word()};
  const ReplyList jpeg = asked.camera ? *rc::gen::arbitrary<ReplyList>() : ReplyList{};
  reply.jpeg = jpeg;
  for (std::size_t i = 0; i < asked.positions.size(); ++i) (void)reply.positions.add(word());
  for (std::size_t i = 0; i < asked.torques.size(); ++i) (void)reply.torques.add(word());
  const Sensors seen = anyImage();
  const std::string sentence = *rc::gen::arbitrary<std::string>();
  if (asked.extended)
    reply.extension = ReplyExtension{.real_time = *rc::gen::arbitrary<bool>(),
                                     .holds_picture = *rc::gen::arbitrary<bool>(),
                                     .held_us = *rc::gen::arbitrary<std::uint32_t>(),
                                     .picture = *rc::gen::arbitrary<std::uint32_t>(),
                                     .seen = *rc::gen::arbitrary<bool>() ? &seen : nullptr,
                                     .why_ended = sentence};
  Reply back;
  ReplyReader reader;
  RC_ASSERT(readReplyInPieces(reader, written(asked, reply), asked, back, *rc::gen::inRange<std::size_t>(1, 1500)) ==
            ReplyReader::Result::kReply);
  RC_ASSERT(back.accelerometer == reply.accelerometer);
  RC_ASSERT(back.gyro == reply.gyro);
  RC_ASSERT(std::ranges::equal(back.jpeg, reply.jpeg));
  RC_ASSERT(back.positions == reply.positions);
  RC_ASSERT(back.torques == reply.torques);
  RC_ASSERT(back.extension.has_value() == asked.extended);
  if (!asked.extended) return;
  RC_ASSERT(back.extension->real_time == reply.extension->real_time);
  RC_ASSERT(back.extension->holds_picture == reply.extension->holds_picture);
  RC_ASSERT(back.extension->held_us == reply.extension->held_us);
  RC_ASSERT(back.extension->picture == reply.extension->picture);
  RC_ASSERT(back.extension->why_ended == sentence);
  RC_ASSERT((back.extension->seen != nullptr) == (reply.extension->seen != nullptr));
  if (back.extension->seen != nullptr) RC_ASSERT(blockOf(*back.extension->seen) == blockOf(seen));
}

RC_GTEST_PROP(SensorBlock, AnyBytesAreAnImage, (const ReplyList& some)) {
  ReplyList bytes(kSensorBlock);
  for (std::size_t i = 0; i < bytes.size() && !some.empty(); ++i) bytes[i] = some[i % some.size()];
  const Sensors seen = readSensors(bytes);
  RC_ASSERT(seen.safety.state < State::kCount);
  RC_ASSERT(row(seen.safety.worst).fault == seen.safety.worst);
}

TEST(SensorBlock, KeepsWhatAControllerReads) {
  Sensors seen;
  seen.joint[18].motion.age = 3;
  seen.joint[18].position = Rad{0.49854};
  seen.joint[19].polled.age = 1000;
  seen.board.buttons = 2;
  seen.board.absent = true;
  seen.board.voltage = Volt{11.8};
  seen.safety.active.set(2);
  seen.safety.worst = Fault::kServoSilent;
  seen.safety.default_p_gain = 3;
  seen.safety.default_speed = 1;
  seen.safety.at_end = Reaction::kHold;
  const Sensors back = readSensors(blockOf(seen));
  EXPECT_EQ(back.joint[18].motion.age, 3);
  EXPECT_NEAR(back.joint[18].position.value, 0.49854, 3e-7);
  EXPECT_EQ(back.joint[19].polled.age, 254) << "as old, or older";
  EXPECT_FALSE(back.joint[19].motion.ever());
  EXPECT_FALSE(back.joint[17].position.known());
  EXPECT_EQ(back.board.buttons, 2);
  EXPECT_TRUE(back.board.absent);
  EXPECT_NEAR(back.board.voltage.value, 11.8, 1e-6);
  EXPECT_EQ(back.safety.active, seen.safety.active);
  EXPECT_EQ(back.safety.worst, Fault::kServoSilent);
  EXPECT_EQ(back.safety.default_p_gain, 3) << "what ends a page or a walk restores";
  EXPECT_EQ(back.safety.default_speed, 1);
  EXPECT_TRUE(std::isnan(back.safety.gentle_speed));
  EXPECT_EQ(back.safety.at_end, Reaction::kHold);
}

TEST(ReplyReader, RejectsRepliesThatAreTooLongOrDoNotMatchTheRequest) {
  for (const ReplyList& bytes :
       {ReplyList{'W', 0, 4, 0x93, 0xE1, 0}, ReplyList{'W', 0xFF, 0xFF, 0xFF, 0xFF}, ReplyList{'W', 0, 0, 0, 4, 0},
        ReplyList{'W', 0, 0, 0, 6, 1, 0}, ReplyList{'W', 0, 0, 0, 9, 0, 0, 0, 1, 0}}) {
    ReplyReader reader;
    Reply reply;
    EXPECT_EQ(readReplyInPieces(reader, bytes, {}, reply, 100), ReplyReader::Result::kInvalid) << +bytes[4];
  }
}

TEST(ReplyReader, RejectsAPictureLongerThanItsReply) {
  Request asked;
  asked.camera = true;
  ReplyReader reader;
  Reply reply;
  EXPECT_EQ(readReplyInPieces(reader, ReplyList{'W', 0, 0, 0, 10, 0xFF, 0xFF, 0xFF, 0xFF, 1, 0}, asked, reply, 100),
            ReplyReader::Result::kInvalid);
}

TEST(ReplyReader, AcceptsTheLongestReply) {
  Request asked;
  asked.camera = true;
  const ReplyList jpeg(kLongestReply - kReplyHead - 4, 7);
  Reply reply, back;
  reply.jpeg = jpeg;
  ReplyReader reader;
  EXPECT_EQ(readReplyInPieces(reader, written(asked, reply), asked, back, 1000), ReplyReader::Result::kReply);
  EXPECT_EQ(back.jpeg.size(), jpeg.size());
  EXPECT_LE(reader.room().size(), kLongestReply + 1);
}

TEST(ReplyReader, AcceptsAReplyWithoutTheExtension) {
  Request asked;
  asked.extended = true;
  Reply reply;
  ReplyReader reader;
  EXPECT_EQ(readReplyInPieces(reader, ReplyList{'W', 0, 0, 0, 5, 0}, asked, reply, 100), ReplyReader::Result::kReply);
  EXPECT_FALSE(reply.extension.has_value());
}

TEST(ReplyReader, SeparatesTwoRepliesInOnePiece) {
  Request asked;
  asked.gyro = true;
  Reply reply;
  reply.gyro = {1, 2, 3};
  ReplyList bytes = written(asked, reply);
  reply.gyro = {4, 5, 6};
  const ReplyList second = written(asked, reply);
  bytes.insert(bytes.end(), second.begin(), second.end());
  ReplyReader reader;
  Reply back;
  ASSERT_EQ(readReplyInPieces(reader, bytes, asked, back, 1000), ReplyReader::Result::kReply);
  EXPECT_EQ(back.gyro[0], 1);
  ASSERT_EQ(reader.next(asked, back), ReplyReader::Result::kReply);
  EXPECT_EQ(back.gyro[0], 4);
}

}  // namespace
}  // namespace darwinop::remote
