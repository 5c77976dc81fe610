// Remote-control reply: result independent of chunking; reads back equal.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "remote/protocol/reply_reader.hpp"
#include "remote/protocol/sensor_block.hpp"

namespace {

using namespace darwinop::remote;
using Bytes = std::span<const std::uint8_t>;

void require(bool holds) {
  if (!holds) std::abort();
}

/// What was asked for: a bit each.
Request questionOf(std::uint8_t bits) {
  Request asked;
  asked.accelerometer = (bits & 1) != 0;
  asked.gyro = (bits & 2) != 0;
  asked.camera = (bits & 4) != 0;
  asked.extended = (bits & 8) != 0;
  for (int i = 0; i < (bits >> 4 & 3); ++i) (void)asked.positions.add(0);
  for (int i = 0; i < bits >> 6; ++i) (void)asked.torques.add(0);
  return asked;
}

struct FoundReplies {
  std::vector<std::vector<std::uint8_t>> rewritten;
  bool refused = false;
  bool operator==(const FoundReplies&) const = default;
};

/// Feeds `stream` in pieces of 1 + chunks[i] bytes, or as much as goes when there are no chunks.
FoundReplies readReplies(Bytes stream, Bytes chunks, const Request& asked) {
  ReplyReader reader;
  FoundReplies found;
  for (std::size_t i = 0; !stream.empty() && !found.refused; ++i) {
    const std::span<std::uint8_t> room = reader.room();
    require(!room.empty() && room.size() <= kLongestReply + 1);
    const std::size_t size = chunks.empty() ? room.size() : 1u + chunks[i % chunks.size()];
    const Bytes piece = stream.first(std::min({stream.size(), size, room.size()}));
    std::ranges::copy(piece, room.begin());
    reader.filled(piece.size());
    stream = stream.subspan(piece.size());
    Reply reply;
    for (;;) {
      const ReplyReader::Found what = reader.next(asked, reply);
      found.refused = what == ReplyReader::Found::kRefused;
      if (what != ReplyReader::Found::kReply) break;
      writeReply(asked, reply, found.rewritten.emplace_back());
    }
  }
  return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Bytes input{data, size};
  const Request asked = questionOf(input[0]);
  const std::size_t chunk_count = std::min<std::size_t>(input[1] % 16, size - 2);
  const Bytes chunks = input.subspan(2, chunk_count), stream = input.subspan(2 + chunk_count);
  const FoundReplies whole = readReplies(stream, {}, asked);
  require(readReplies(stream, chunks, asked) == whole);
  for (const std::vector<std::uint8_t>& bytes : whole.rewritten) {
    const FoundReplies again = readReplies(bytes, {}, asked);
    require(again.rewritten.size() == 1 && again.rewritten[0] == bytes);
  }
  return 0;
}
