// What waits to be sent to one peer: bounded, whatever comes in and however little goes out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace darwinop::web {

/// One message for any number of peers.
using Bytes = std::shared_ptr<const std::string>;

/// 0 to 8: the newest of a lane replaces the one before it.
using Lane = std::uint8_t;
inline constexpr Lane kLanes = 9;
/// Messages that do not replace each other; of too many the oldest goes.
inline constexpr Lane kEvery = kLanes;

struct Parcel {
  Lane lane = 0;
  bool binary = false;
  Bytes bytes;
};

class Outbox {
 public:
  static constexpr std::size_t kMostOfEvery = 32;

  /// One that is replaced hands its place to the newer one, so that no lane can starve another.
  void put(Parcel parcel);
  /// The one that has waited for the longest time.
  [[nodiscard]] std::optional<Parcel> take();
  /// Lanes 0 to 8 are emptied; that is no loss.
  void forgetNewest();

  [[nodiscard]] std::size_t size() const { return waiting_.size(); }
  /// Replaced or dropped so far.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  std::deque<Parcel> waiting_;
  std::uint64_t lost_ = 0;
};

}  // namespace darwinop::web
