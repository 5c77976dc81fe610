// FrameReader as properties: what it finds does not depend on how the bytes arrive, nor on garbage between frames.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/packet.hpp"
#include "support/hex.hpp"

namespace darwinop {
namespace {

using ByteVector = std::vector<std::uint8_t>;

std::string text(const Frame& frame) {
  return std::to_string(frame.id) + "/" + std::to_string(frame.code) + ": " + toHex(frame.params);
}

struct Found {
  std::vector<std::string> frames;
  std::uint32_t garbage = 0, bad_checksums = 0;
  bool operator==(const Found&) const = default;
};

void drain(FrameReader& reader, Found& found, bool more_expected) {
  while (const auto frame = reader.next(more_expected)) found.frames.push_back(text(*frame));
}

/// Feeds `bytes` in pieces of `chunk(i)` bytes and collects everything.
template <class Chunk>
Found readAll(const ByteVector& bytes, Chunk chunk) {
  FrameReader reader;
  Found found;
  Bytes rest{bytes};
  for (std::size_t i = 0; !rest.empty(); ++i) {
    Bytes piece = rest.first(std::min(rest.size(), chunk(i)));
    rest = rest.subspan(piece.size());
    while (!piece.empty()) {
      piece = piece.subspan(reader.feed(piece));
      drain(reader, found, true);
    }
  }
  drain(reader, found, false);
  found.garbage = reader.garbageBytes();
  found.bad_checksums = reader.badChecksums();
  return found;
}

Found readAtOnce(const ByteVector& bytes) {
  return readAll(bytes, [&](std::size_t) { return bytes.size(); });
}

ByteVector status(std::uint8_t id, std::uint8_t error, const ByteVector& params) {
  std::array<std::uint8_t, kMaxFrame> buffer{};
  const auto frame = encodeStatus(buffer, id, error, params);
  return {frame.begin(), frame.end()};
}

void append(ByteVector& stream, const ByteVector& bytes) {
  stream.insert(stream.end(), bytes.begin(), bytes.end());
}

/// Bytes among which header bytes are common, so that false starts happen.
rc::Gen<std::uint8_t> treacherousByte() {
  return rc::gen::weightedOneOf<std::uint8_t>({{1, rc::gen::just<std::uint8_t>(0xFF)},
                                               {2, rc::gen::inRange<std::uint8_t>(0, 8)},
                                               {2, rc::gen::arbitrary<std::uint8_t>()}});
}
rc::Gen<std::uint8_t> byteThatStartsNothing() {
  return rc::gen::inRange<std::uint8_t>(0, 255);
}
rc::Gen<std::uint8_t> anyId() {
  return rc::gen::inRange<std::uint8_t>(0, 254);
}

/// Frames and garbage, mixed.
ByteVector anyStream() {
  ByteVector stream;
  const int parts = *rc::gen::inRange(0, 8);
  for (int i = 0; i < parts; ++i) {
    const auto bytes = *rc::gen::container<ByteVector>(treacherousByte());
    append(stream, *rc::gen::arbitrary<bool>() ? bytes : status(*anyId(), 0, bytes));
  }
  return stream;
}

RC_GTEST_PROP(FrameReaderProperty, FindsTheSameHoweverTheBytesArrive, ()) {
  const ByteVector stream = anyStream();
  const auto sizes =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 300)));
  const Found whole = readAtOnce(stream);
  RC_ASSERT(readAll(stream, [&](std::size_t i) { return sizes[i % sizes.size()]; }).frames == whole.frames);
  RC_ASSERT(readAll(stream, [](std::size_t) { return std::size_t{1}; }) == whole);
}

RC_GTEST_PROP(FrameReaderProperty, EncodedFramesComeBackInOrder, ()) {
  ByteVector stream;
  std::vector<std::string> sent;
  const auto count = *rc::gen::inRange<std::size_t>(0, 25);
  while (sent.size() < count) {
    const auto id = *anyId();
    const auto error = *rc::gen::inRange<std::uint8_t>(0, 128);
    const auto params = *rc::gen::container<ByteVector>(treacherousByte());
    append(stream, status(id, error, params));
    sent.push_back(text({id, error, params}));
  }
  const Found found = readAtOnce(stream);
  RC_ASSERT(found.frames == sent);
  RC_ASSERT(found.garbage == 0u);
}

RC_GTEST_PROP(FrameReaderProperty, GarbageBeforeAFrameIsCountedAndCostsNoFrame, ()) {
  ByteVector stream = *rc::gen::container<ByteVector>(byteThatStartsNothing());
  const auto garbage = stream.size();
  append(stream, status(7, 0, {1, 2, 3}));
  const Found found = readAtOnce(stream);
  RC_ASSERT(found.frames == std::vector<std::string>{"7/0: 01 02 03"});
  RC_ASSERT(found.garbage == garbage);
}

RC_GTEST_PROP(FrameReaderProperty, AChangedParameterLosesThatFrameOnly, ()) {
  const auto params = *rc::gen::nonEmpty(rc::gen::container<ByteVector>(byteThatStartsNothing()));
  ByteVector stream = status(3, 0, params);
  const auto at = 5 + *rc::gen::inRange<std::size_t>(0, params.size());
  stream[at] = *rc::gen::suchThat(byteThatStartsNothing(), [&](std::uint8_t b) { return b != stream[at]; });
  append(stream, status(4, 0, {9}));
  const Found found = readAtOnce(stream);
  RC_ASSERT(found.frames == std::vector<std::string>{"4/0: 09"});
  RC_ASSERT(found.bad_checksums == 1u);
}

TEST(FrameReader, AThirdHeaderByteIsSkippedWithoutWaitingForMore) {
  FrameReader reader;
  reader.feed(fromHex("ff ff ff 05 02 00 f8"));
  const auto frame = reader.next(true);
  ASSERT_TRUE(frame);
  EXPECT_EQ(text(*frame), "5/0: ");
  EXPECT_EQ(reader.garbageBytes(), 1u);
}

TEST(FrameReader, AHeaderInsideParametersIsData) {
  const ByteVector inner = status(5, 0, {});
  const Found found = readAtOnce(status(6, 0, inner));
  EXPECT_EQ(found.frames, std::vector<std::string>{"6/0: ff ff 05 02 00 f8"});
}

TEST(FrameReader, ACutFrameHidesTheNextOnlyUntilNoMoreIsExpected) {
  ByteVector stream = fromHex("ff ff 02 0a 00 01 02");  // says 14 bytes, 7 came
  append(stream, status(1, 0, {}));
  FrameReader reader;
  ASSERT_EQ(reader.feed(stream), stream.size());
  EXPECT_FALSE(reader.next(true));
  const auto frame = reader.next(false);
  ASSERT_TRUE(frame);
  EXPECT_EQ(text(*frame), "1/0: ");
}

/// What the reader says of the boundary behind the first frame of `stream`.
bool boundaryLostBehindTheFirst(const ByteVector& stream) {
  FrameReader reader;
  reader.feed(stream);
  EXPECT_TRUE(reader.next(true));
  EXPECT_FALSE(reader.boundaryLost());
  reader.next(false);
  return reader.boundaryLost();
}

TEST(FrameReader, ReportsWhenNoFrameBeginsWhereTheLastOneEnded) {
  ByteVector whole = status(3, 0, {9});
  append(whole, status(4, 0, {9}));
  EXPECT_FALSE(boundaryLostBehindTheFirst(whole));

  // Its checksum was lost, or a parameter: the first byte of the next header is a valid checksum of what is left.
  ByteVector cut = fromHex("ff ff 03 03 00 fa");
  append(cut, status(4, 0, {9}));
  EXPECT_TRUE(boundaryLostBehindTheFirst(cut));

  for (const std::uint8_t more : std::initializer_list<std::uint8_t>{0x00, 0xFF}) {
    ByteVector behind = status(3, 0, {9});
    behind.push_back(more);
    EXPECT_TRUE(boundaryLostBehindTheFirst(behind)) << "one byte behind the last frame";
    append(behind, status(4, 0, {9}));
    EXPECT_TRUE(boundaryLostBehindTheFirst(behind));
  }
}

TEST(FrameReader, ABadFrameBehindAGoodOneIsNotALostBoundary) {
  ByteVector stream = status(3, 0, {9});
  append(stream, fromHex("ff ff 04 03 00 09 00"));  // checksum wrong
  append(stream, status(5, 0, {9}));
  EXPECT_FALSE(boundaryLostBehindTheFirst(stream));
}

TEST(FrameReader, ALengthTooSmallForAFrameIsGarbage) {
  ByteVector stream = fromHex("ff ff 01 01 fd");
  append(stream, status(2, 4, {}));
  EXPECT_EQ(readAtOnce(stream).frames, std::vector<std::string>{"2/4: "});
}

TEST(FrameReader, ClearForgetsBytesAndKeepsCounters) {
  FrameReader reader;
  reader.feed(fromHex("00 00 00 00 00 00 00 00 ff ff 01"));
  EXPECT_FALSE(reader.next());
  const auto garbage = reader.garbageBytes();
  EXPECT_GT(garbage, 0u);
  EXPECT_GT(reader.pending(), 0u);
  reader.clear();
  EXPECT_EQ(reader.pending(), 0u);
  EXPECT_EQ(reader.garbageBytes(), garbage);
}

}  // namespace
}  // namespace darwinop
