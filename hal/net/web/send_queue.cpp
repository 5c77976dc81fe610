// Bounded send queue of one WebSocket connection.
#include "hal/net/web/send_queue.hpp"

#include <algorithm>
#include <utility>

namespace darwinop::web {

void SendQueue::put(OutgoingMessage message) {
  message.lane = std::min(message.lane, kEvery);
  const auto same = [lane = message.lane](const OutgoingMessage& other) { return other.lane == lane; };
  const auto oldest = std::ranges::find_if(waiting_, same);
  if (message.lane != kEvery && oldest != waiting_.end()) {
    *oldest = std::move(message);
    ++lost_;
    return;
  }
  if (message.lane == kEvery && static_cast<std::size_t>(std::ranges::count_if(waiting_, same)) == kMaxOfEvery) {
    waiting_.erase(oldest);
    ++lost_;
  }
  waiting_.push_back(std::move(message));
}

std::optional<OutgoingMessage> SendQueue::take() {
  if (waiting_.empty()) return std::nullopt;
  OutgoingMessage message = std::move(waiting_.front());
  waiting_.pop_front();
  return message;
}

void SendQueue::discardQueued() {
  std::erase_if(waiting_, [](const OutgoingMessage& message) { return message.lane != kEvery; });
}

}  // namespace darwinop::web
