// Bounded sample queue from the speech thread to the mixer.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

class Spoken {
 public:
  explicit Spoken(int rate) : rate_{rate} {}

  [[nodiscard]] int rate() const { return rate_; }

  /// Blocks while two seconds are buffered. Returns false if the consumer has cancelled.
  [[nodiscard]] bool put(std::span<const std::int16_t> samples) {
    std::unique_lock lock{mutex_};
    const auto most = 2 * static_cast<std::size_t>(rate_);
    room_.wait(lock, [&] { return given_up_ || samples_.size() < most; });
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    return !given_up_;
  }
  void complete() {
    const std::lock_guard lock{mutex_};
    complete_ = true;
  }

  std::size_t take(std::span<AudioFrame> frames) {
    const std::lock_guard lock{mutex_};
    const std::size_t count = std::min(frames.size(), samples_.size());
    for (std::size_t i = 0; i < count; ++i) {
      const float value = static_cast<float>(samples_[i]) / 32768.0F;
      frames[i] = {value, value};
    }
    samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count));
    room_.notify_one();
    return count;
  }
  [[nodiscard]] bool drained() {
    const std::lock_guard lock{mutex_};
    return complete_ && samples_.empty();
  }
  void giveUp() {
    const std::lock_guard lock{mutex_};
    given_up_ = true;
    room_.notify_one();
  }
  [[nodiscard]] bool givenUp() {
    const std::lock_guard lock{mutex_};
    return given_up_;
  }

 private:
  const int rate_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::deque<std::int16_t> samples_;
  bool complete_ = false, given_up_ = false;
};

}  // namespace darwinop::audio
