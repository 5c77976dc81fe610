// Hands large values from one thread to another: one writes, one reads, neither ever waits or copies.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace darwinop {

/// Three places: the writer fills one, the reader looks at one, the third changes hands by one atomic exchange. The
/// newest value wins; what the reader looks at stays as it is until it asks for a newer one.
///
/// runtime::Latest is for small values and many readers: it copies word by word. A picture is too large for that.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& everywhere) : places_{everywhere, everywhere, everywhere} {}

  /// Writing thread only: the place to fill. What it holds is two or more values old.
  [[nodiscard]] T& back() noexcept { return places_[back_]; }
  /// Writing thread only: back() becomes the newest value, and another place becomes back().
  void publish() noexcept {
    back_ = static_cast<std::uint8_t>(between_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kPlace);
  }

  /// Reading thread only: takes the newest value, if there is one since the last call.
  bool update() noexcept {
    if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = static_cast<std::uint8_t>(between_.exchange(front_, std::memory_order_acq_rel) & kPlace);
    return true;
  }
  /// Reading thread only: the value last taken.
  [[nodiscard]] const T& front() const noexcept { return places_[front_]; }

 private:
  static constexpr std::uint8_t kPlace = 3, kFresh = 4;
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

  std::array<T, 3> places_;
  std::atomic<std::uint8_t> between_{1};  // a place, and kFresh when the reader has not seen it
  // On lines of their own: each is written by its thread at every picture.
  alignas(64) std::uint8_t back_ = 0;   // the writer's
  alignas(64) std::uint8_t front_ = 2;  // the reader's
};

}  // namespace darwinop
