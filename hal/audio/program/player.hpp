// The thread that mixes and feeds the card, at the pace of real time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "hal/audio/mixer.hpp"
#include "hal/audio/program/card.hpp"

namespace darwinop::audio {

class Player {
 public:
  /// `tell` is called from its thread.
  explicit Player(std::function<void(const SoundNews&)> tell);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// What `change` does to the mixer happens between two pieces.
  template <class Change>
  auto with(Change change) {
    const std::lock_guard lock{mutex_};
    auto result = change(mixer_);
    changed_.notify_one();
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;
  void run();
  void sound();
  void write(std::unique_ptr<Card>& card, std::span<const Sample> piece);
  void tellEnded(Clock::time_point heard);

  std::function<void(const SoundNews&)> tell_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Mixer mixer_;
  bool ending_ = false;
  struct Ended {
    Clock::time_point heard;
    SoundId id;
  };
  std::deque<Ended> ended_;  // in the card, not heard yet
  std::thread thread_;
};

}  // namespace darwinop::audio
