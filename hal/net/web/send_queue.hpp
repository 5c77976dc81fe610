// Bounded send queue of one WebSocket connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace darwinop::web {

/// One message, shared by all peers it is sent to.
using Bytes = std::shared_ptr<const std::string>;

/// 0 to 8: the newest message of a lane replaces a waiting one.
using Lane = std::uint8_t;
inline constexpr Lane kLanes = 9;
/// Messages that do not replace each other; beyond kMaxOfEvery the oldest is dropped.
inline constexpr Lane kEvery = kLanes;

struct OutgoingMessage {
  Lane lane = 0;
  bool binary = false;
  Bytes bytes;
};

class SendQueue {
 public:
  static constexpr std::size_t kMaxOfEvery = 32;

  /// A replacement takes the position of the message it replaces, so that no lane starves another.
  void put(OutgoingMessage message);
  /// The oldest message.
  [[nodiscard]] std::optional<OutgoingMessage> take();
  /// Empties lanes 0 to 8; these messages do not count as lost.
  void discardQueued();

  [[nodiscard]] std::size_t size() const { return waiting_.size(); }
  /// Messages replaced or dropped so far.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  std::deque<OutgoingMessage> waiting_;
  std::uint64_t lost_ = 0;
};

}  // namespace darwinop::web
