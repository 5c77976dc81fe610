// One request, one answer, a few tries: for start-up and tools, never in the loop.
#include "hal/cm730/diagnosis/transactions.hpp"

#include <algorithm>

#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::size_t kMostParams = std::tuple_size_v<decltype(Answer::bytes)>;

bool take(const Frame& frame, std::uint8_t id, std::size_t params, Answer& answer) {
  if (frame.id != id || frame.params.size() != params) return false;
  answer.error_bits = frame.code;
  answer.count = params;
  std::ranges::copy(frame.params, answer.bytes.begin());
  return true;
}

LineStatus await(ByteLine& line, std::uint8_t id, std::size_t params, Nanos deadline, Answer& answer) {
  FrameReader reader;
  std::array<std::uint8_t, 256> incoming;
  while (true) {
    std::size_t count = 0;
    const LineStatus status = line.read(incoming, count, deadline);
    if (status != LineStatus::kOk) {
      // Another device's frame does not count as noise, but half of one does.
      answer.garbled |= reader.pending() > 0 || reader.garbageBytes() > 0;
      return status;
    }
    for (Bytes rest{incoming.data(), count}; !rest.empty();) {
      rest = rest.subspan(reader.feed(rest));
      while (const auto frame = reader.next())
        if (take(*frame, id, params, answer)) return LineStatus::kOk;
    }
    if (line.now() >= deadline) {  // a line that babbles
      answer.garbled = true;
      return LineStatus::kTimeout;
    }
  }
}

Answer exchange(ByteLine& line, std::uint8_t id, Bytes request, std::size_t params, const Patience& patience) {
  Answer answer;
  if (request.empty() || params > kMostParams) return answer;
  while (answer.tries < patience.tries) {
    ++answer.tries;
    line.discardInput();
    const Nanos asked = line.now();
    answer.status = line.write(request);
    if (answer.status == LineStatus::kOk) {
      const Nanos wire = wireTime(request.size() + params + kFrameOverhead);
      answer.status = await(line, id, params, asked + wire + patience.margin, answer);
    }
    if (answer.status == LineStatus::kTimeout) continue;
    answer.took = line.now() - asked;
    break;
  }
  return answer;
}

}  // namespace

Answer ping(ByteLine& line, std::uint8_t id, const Patience& patience) {
  std::array<std::uint8_t, kMaxFrame> frame{};
  return exchange(line, id, encodePing(frame, id), 0, patience);
}

Answer readRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, std::uint8_t count,
                     const Patience& patience) {
  std::array<std::uint8_t, kMaxFrame> frame{};
  return exchange(line, id, encodeRead(frame, id, address, count), count, patience);
}

Answer writeRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, Bytes data, const Patience& patience) {
  std::array<std::uint8_t, kMaxFrame> frame{};
  return exchange(line, id, encodeWrite(frame, id, address, data), 0, patience);
}

LineStatus pass(ByteLine& line, Nanos duration) {
  const Nanos deadline = line.now() + duration;
  std::array<std::uint8_t, 256> rubbish;
  while (line.now() < deadline) {
    std::size_t count = 0;
    if (line.read(rubbish, count, deadline) == LineStatus::kLost) return LineStatus::kLost;
  }
  return LineStatus::kOk;
}

}  // namespace darwinop::cm730
