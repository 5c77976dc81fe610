// Remote-control request: result independent of chunking; reads back equal.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "remote/protocol/request_reader.hpp"
#include "remote/protocol/request_writer.hpp"

namespace {

using namespace darwinop::remote;
using Bytes = std::span<const std::uint8_t>;

void require(bool holds) {
  if (!holds) std::abort();
}

struct FoundRequests {
  std::vector<Request> requests;
  std::vector<Oddities> oddities;
  std::size_t garbage = 0;
  bool refused = false;
  bool operator==(const FoundRequests&) const = default;
};

/// Feeds `stream` in pieces of 1 + chunks[i] bytes, or as much as goes when there are no chunks.
FoundRequests readStream(Bytes stream, Bytes chunks) {
  RequestReader reader;
  FoundRequests found;
  std::size_t fed = 0, used = 0;
  for (std::size_t i = 0; !stream.empty() && !found.refused; ++i) {
    const std::span<std::uint8_t> room = reader.room();
    require(!room.empty());  // a drained reader always has room
    const std::size_t size = chunks.empty() ? room.size() : 1u + chunks[i % chunks.size()];
    const Bytes piece = stream.first(std::min({stream.size(), size, room.size()}));
    std::ranges::copy(piece, room.begin());
    reader.filled(piece.size());
    stream = stream.subspan(piece.size());
    fed += piece.size();
    Request request;
    Oddities oddities;
    for (;;) {
      const std::size_t before = reader.pending() + reader.garbageBytes();
      const RequestReader::Found what = reader.next(request, oddities);
      found.refused = what == RequestReader::Found::kRefused;
      if (what != RequestReader::Found::kRequest) break;
      used += before - reader.pending() - reader.garbageBytes();
      found.requests.push_back(request);
      found.oddities.push_back(oddities);
    }
    require(fed == used + reader.garbageBytes() + reader.pending());
  }
  found.garbage = reader.garbageBytes();
  return found;
}

/// Motors that do not exist are left out, so they are not written again.
void requireSameAgain(const Request& request) {
  RequestBuffer buffer;
  const Bytes written = writeRequest(request, buffer);
  const FoundRequests again = readStream(written, {});
  require(again.requests.size() == 1 && again.requests[0] == request);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes input{data, size};
  const std::size_t chunk_count = std::min<std::size_t>(input[0] % 16, size - 1);
  const Bytes chunks = input.subspan(1, chunk_count), stream = input.subspan(1 + chunk_count);
  const FoundRequests whole = readStream(stream, {});
  require(readStream(stream, chunks) == whole);
  for (const Request& request : whole.requests) requireSameAgain(request);
  return 0;
}
