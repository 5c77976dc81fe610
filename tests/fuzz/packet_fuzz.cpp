// FrameReader: result independent of chunking; frames encode to the same bytes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/packet.hpp"

namespace {

using namespace darwinop;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Found {
  std::vector<std::uint8_t> frames;  // each encoded again, one behind the other
  std::size_t accounted = 0;         // bytes in frames, garbage or pending
  bool operator==(const Found&) const = default;
};

void collect(FrameReader& reader, Found& found, bool more_expected) {
  while (const auto frame = reader.next(more_expected)) {
    std::array<std::uint8_t, kMaxFrame> buffer{};
    const auto encoded = encodeStatus(buffer, frame->id, frame->code, frame->params);
    require(encoded.size() == frame->params.size() + kFrameOverhead);
    found.frames.insert(found.frames.end(), encoded.begin(), encoded.end());
  }
}

/// Feeds `stream` in pieces of 1 + chunks[i] bytes, or whole when there are no chunks.
Found readAll(Bytes stream, Bytes chunks) {
  FrameReader reader;
  Found found;
  for (std::size_t i = 0; !stream.empty(); ++i) {
    const std::size_t size = chunks.empty() ? stream.size() : 1u + chunks[i % chunks.size()];
    Bytes piece = stream.first(std::min(stream.size(), size));
    stream = stream.subspan(piece.size());
    while (!piece.empty()) {
      const std::size_t taken = reader.feed(piece);
      require(taken > 0);  // a drained reader always has room
      piece = piece.subspan(taken);
      collect(reader, found, true);
    }
  }
  collect(reader, found, false);
  found.accounted = found.frames.size() + reader.garbageBytes() + reader.pending();
  return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes input{data, size};
  const std::size_t chunk_count = std::min<std::size_t>(input[0] % 16, size - 1);
  const Bytes chunks = input.subspan(1, chunk_count), stream = input.subspan(1 + chunk_count);

  const Found whole = readAll(stream, {});
  require(whole.accounted == stream.size());
  require(readAll(stream, chunks) == whole);
  return 0;
}
