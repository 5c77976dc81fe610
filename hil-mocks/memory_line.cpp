// In-memory line in simulated time.
#include "hil-mocks/memory_line.hpp"

#include <algorithm>

namespace darwinop::hil {

void MemoryLine::advanceTo(Nanos when) noexcept {
  now_ = std::max(now_, when);
  robot_.advance(now_);
}

LineStatus MemoryLine::write(std::span<const std::uint8_t> bytes) noexcept {
  robot_.advance(now_);
  if (!robot_.portOpen()) return LineStatus::kLost;
  robot_.receive(bytes, now_);
  counters_.bytes_out += bytes.size();
  while (!bytes.empty()) {
    bytes = bytes.subspan(sent_.feed(bytes));
    while (const std::optional<Frame> frame = sent_.next()) {
      ++counters_.frames;
      if (frame->code == static_cast<std::uint8_t>(Instruction::kSyncWrite)) ++counters_.sync_writes;
      if (frame->code == static_cast<std::uint8_t>(Instruction::kBulkRead)) ++counters_.bulk_reads;
      if (observer_ != nullptr) observer_->request(*frame, now_);
    }
  }
  return LineStatus::kOk;
}

LineStatus MemoryLine::read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept {
  count = 0;
  deadline = std::max(deadline, now_);
  ChunkRing& output = robot_.output();
  while (true) {
    if (!robot_.portOpen()) return LineStatus::kLost;
    if (!output.empty() && output.front().at <= deadline) break;
    if (!output.empty() || robot_.now() >= deadline) {
      advanceTo(deadline);
      return robot_.portOpen() ? LineStatus::kTimeout : LineStatus::kLost;
    }
    robot_.advanceToReply(deadline);
    now_ = std::max(now_, robot_.now());
  }
  Chunk& chunk = output.front();
  now_ = std::max(now_, chunk.at);
  count = std::min(into.size(), chunk.size);
  std::copy_n(chunk.data.begin(), count, into.begin());
  counters_.bytes_in += count;
  if (observer_ != nullptr) observer_->reply(chunk.bytes().first(count), now_);
  chunk.dropFront(count);
  if (chunk.size == 0) output.pop();
  return LineStatus::kOk;
}

void MemoryLine::discardInput() noexcept {
  for (ChunkRing& output = robot_.output(); !output.empty() && output.front().at <= now_;) output.pop();
}

}  // namespace darwinop::hil
