// Replies to a BulkRead: result independent of chunking; a reading has a valid frame of its device, in list order.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/conversions.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "hal/cm730/request_tag.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::cm730;
using List = std::vector<ReadList::Entry>;

constexpr std::size_t kHead = 7;

void require(bool holds) {
  if (!holds) std::abort();
}

/// What was asked. Without a board the first servo of the list opens the exchange.
struct Request {
  List list;
  bool board;
  std::uint8_t first_bytes;
};

struct Result {
  BusReadings readings;
  ReadList::Mask answered;
  std::uint32_t late = 0;
};

/// Some of the joints, once each, in an order that the input chooses.
List listOf(Bytes head) {
  constexpr std::array<std::size_t, 4> kStrides{1, 3, 7, 19};  // relatively prime to the number of joints
  List list(head[2] % (kJoints + 1));
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::size_t joint = (head[3] / 4U + i * kStrides[head[3] % 4]) % kJoints;
    list[i] = {static_cast<std::uint8_t>(joint), (head[4 + i / 8] >> (i % 8) & 1) != 0};
  }
  return list;
}

/// Makes the checksums of complete frames right, or hardly any input would get past them.
void seal(std::vector<std::uint8_t>& stream) {
  for (std::size_t at = 0; at + kFrameOverhead <= stream.size(); ++at) {
    const std::size_t size = stream[at + 3] + 4U;
    if (stream[at] != 0xFF || stream[at + 1] != 0xFF || size < kFrameOverhead || at + size > stream.size()) continue;
    stream[at + size - 1] = checksum(Bytes{stream}.subspan(at + 2, size - 3));
    at += size - 1;
  }
}

Request requestOf(Bytes head) {
  Request asked{.list = listOf(head), .board = (head[2] & 0x80) == 0, .first_bytes = 0};
  const int least = asked.board ? kBoardWindow.count : RequestTag::kLeastServoBytes;
  const int most = asked.board ? RequestTag::kMostBytes : RequestTag::kMostServoBytes;
  asked.first_bytes = static_cast<std::uint8_t>(least + head[1] % (most - least + 1));
  if (!asked.board && !asked.list.empty()) asked.list[0].poll = true;
  return asked;
}

/// Feeds `stream` in pieces of 1 + chunks[i] bytes, or whole when there are no chunks.
Result decode(const Request& asked, Bytes stream, Bytes chunks) {
  Result result;
  result.readings.forget();
  FrameReader reader;
  ReplyDecoder decoder{{}, {}, {}, asked.board};
  decoder.begin(asked.list, asked.first_bytes, result.readings);
  for (std::size_t i = 0; !stream.empty(); ++i) {
    const std::size_t size = chunks.empty() ? FrameReader::kRoom : 1U + chunks[i % chunks.size()];
    const std::size_t taken = reader.feed(stream.first(std::min(stream.size(), size)));
    require(taken > 0);
    stream = stream.subspan(taken);
    decoder.takeAll(reader);
  }
  decoder.takeAll(reader, false);
  require(decoder.complete() == (decoder.nextFrameBytes() == 0));
  require(decoder.firstAnswered() == (asked.board ? result.readings.board.answered : result.readings.servos_answered));
  require(decoder.answerBytes() >= asked.first_bytes);
  result.answered = decoder.answered();
  result.late = decoder.lateReplies();
  return result;
}

struct Reply {
  std::uint8_t id, error;
  std::vector<std::uint8_t> params;
};

std::vector<Reply> repliesIn(Bytes stream) {
  std::vector<Reply> all;
  FrameReader reader;
  const auto take = [&](bool more_expected) {
    while (const auto frame = reader.next(more_expected))
      all.push_back({frame->id, frame->code, {frame->params.begin(), frame->params.end()}});
  };
  for (; !stream.empty(); take(true)) stream = stream.subspan(reader.feed(stream));
  take(false);
  return all;
}

void requireFrames(const Result& result, const Request& asked, Bytes stream) {
  const std::vector<Reply> replies = repliesIn(stream);
  require(result.late <= replies.size());
  auto at = replies.begin();
  if (asked.board) {
    at = std::ranges::find_if(
        replies, [&](const Reply& reply) { return reply.id == kBoardId && reply.params.size() == asked.first_bytes; });
    require(!result.readings.board.answered || at != replies.end());
    require(result.answered.none() || result.readings.board.answered);
  } else {
    require(!result.readings.board.answered);
    require(result.answered.none() || result.answered[asked.list[0].joint]);
  }
  ReadList::Mask listed;
  for (const ReadList::Entry entry : asked.list) {
    const bool opens = !asked.board && listed.none();
    listed.set(entry.joint);
    const ServoReading& reading = result.readings.servo[entry.joint];
    require(reading.answered == result.answered[entry.joint]);
    require(!reading.polled || (reading.answered && entry.poll));
    if (!reading.answered) continue;
    at = std::find_if(at, replies.end(), [&](const Reply& reply) {
      const std::size_t size = opens ? asked.first_bytes : kServoWindows[entry.poll].count;
      if (reply.id != servoId(entry.joint) || reply.params.size() != size) return false;
      const std::size_t poll_at = opens ? size - kServoPoll.count : 0;
      const std::size_t motion_at = entry.poll ? poll_at + kServoWindow.address - kServoPoll.address : 0;
      const std::uint16_t ticks = wordAt(reply.params, motion_at);
      return ticks <= kTickMax && reading.position == radFromTicks(ticks) && reading.error_bits == reply.error;
    });
    require(at++ != replies.end());
    require(std::isfinite(reading.velocity.value) && std::abs(reading.load) <= 1);
  }
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    require(listed[joint] || (!result.readings.servo[joint].answered && std::isnan(result.readings.servo[joint].load)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < kHead) return 0;
  const Bytes input{data, size};
  const Request asked = requestOf(input);
  const std::size_t chunk_count = std::min<std::size_t>(input[0] % 16, size - kHead);
  const Bytes chunks = input.subspan(kHead, chunk_count), rest = input.subspan(kHead + chunk_count);
  std::vector<std::uint8_t> stream{rest.begin(), rest.end()};
  if (input[0] < 0xC0) seal(stream);

  const Result whole = decode(asked, stream, {});
  requireFrames(whole, asked, stream);
  const Result parts = decode(asked, stream, chunks);
  require(parts.answered == whole.answered && parts.late == whole.late);
  require(parts.readings.board.answered == whole.readings.board.answered);
  require(parts.readings.servos_answered == whole.readings.servos_answered);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    require(!whole.answered[joint] || parts.readings.servo[joint].position == whole.readings.servo[joint].position);
  return 0;
}
