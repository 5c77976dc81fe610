#include "hal/net/web/outbox.hpp"

#include <algorithm>
#include <utility>

namespace darwinop::web {

void Outbox::put(Parcel parcel) {
  parcel.lane = std::min(parcel.lane, kEvery);
  const auto same = [lane = parcel.lane](const Parcel& other) { return other.lane == lane; };
  const auto oldest = std::ranges::find_if(waiting_, same);
  if (parcel.lane != kEvery && oldest != waiting_.end()) {
    *oldest = std::move(parcel);
    ++lost_;
    return;
  }
  if (parcel.lane == kEvery && static_cast<std::size_t>(std::ranges::count_if(waiting_, same)) == kMostOfEvery) {
    waiting_.erase(oldest);
    ++lost_;
  }
  waiting_.push_back(std::move(parcel));
}

std::optional<Parcel> Outbox::take() {
  if (waiting_.empty()) return std::nullopt;
  Parcel parcel = std::move(waiting_.front());
  waiting_.pop_front();
  return parcel;
}

void Outbox::forgetNewest() {
  std::erase_if(waiting_, [](const Parcel& parcel) { return parcel.lane != kEvery; });
}

}  // namespace darwinop::web
