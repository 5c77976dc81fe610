// Synchronizes board and faults.
#include "hil-mocks/virtual_robot.hpp"

#include <algorithm>

namespace darwinop::hil {

VirtualRobot::VirtualRobot(const BoardOptions& options, std::uint64_t seed, std::unique_ptr<Body> body)
    : body_{body ? std::move(body) : std::make_unique<PlainBody>()}, board_{options, *body_}, faults_{seed} {}

void VirtualRobot::receive(Bytes bytes, Nanos when) noexcept {
  while (portOpen() && !bytes.empty()) {
    const Bytes piece = bytes.first(std::min(bytes.size(), kMaxFrame));
    Chunk chunk{piece, when};
    faults_.pass(chunk, Way::kRequests);
    board_.receive(chunk.bytes(), chunk.at);
    bytes = bytes.subspan(piece.size());
  }
}

std::optional<Nanos> VirtualRobot::nextWake() const noexcept {
  Nanos wake = std::min(board_.earliestReply().value_or(Nanos::max()), faults_.nextChange());
  if (!output_.empty()) wake = std::min(wake, output_.front().at);
  if (wake == Nanos::max()) return std::nullopt;
  return wake;
}

void VirtualRobot::advance(Nanos until, bool stop_at_reply) noexcept {
  while (true) {
    if (faults_.nextChange() <= now_) applyFaults();
    const Nanos stop = std::min(until, faults_.nextChange());
    board_.advance(stop, stop_at_reply);
    now_ = std::max(now_, board_.now());
    collectReplies();
    if (stop_at_reply && !output_.empty()) return;
    if (now_ >= until && faults_.nextChange() > now_) return;
  }
}

void VirtualRobot::applyFaults() noexcept {
  const bool was_open = portOpen();
  faults_.apply(now_, board_);
  if (was_open && !portOpen()) output_.clear();
  if (!was_open && portOpen()) ++replugs_;
}

void VirtualRobot::collectReplies() noexcept {
  for (ChunkRing& replies = board_.output(); !replies.empty(); replies.pop()) {
    if (!portOpen()) continue;
    Chunk& chunk = replies.front();
    faults_.pass(chunk, Way::kReplies);
    last_at_ = chunk.at = std::max(chunk.at, last_at_);  // a delayed frame also delays those behind it
    if (chunk.size > 0) output_.push(chunk.bytes(), chunk.at);
  }
}

}  // namespace darwinop::hil
