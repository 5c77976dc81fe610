// Playback thread: mixes in blocks and writes them to the card in real time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>

#include "hal/audio/mixer.hpp"
#include "hal/audio/program/card.hpp"

namespace darwinop::audio {

class SoundPlayer {
 public:
  /// `report` is called from the playback thread.
  explicit SoundPlayer(std::function<void(const SoundEvent&)> report);
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  /// Runs `change` on the mixer between two blocks.
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
  void openTheCard();
  void reportCard(const std::string& error);
  void playUntilSilence();
  void write(std::span<const Sample> piece);
  void reportEnded(Clock::time_point played_at);

  std::function<void(const SoundEvent&)> report_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Mixer mixer_;
  bool ending_ = false;
  struct Ended {
    Clock::time_point played_at;
    SoundId id;
  };
  std::deque<Ended> ended_;     // in the card's buffer, not played yet
  std::unique_ptr<Card> card_;  // of the playback thread, while something sounds
  Clock::time_point tried_{};   // to open it
  std::string card_error_;      // reported last
  std::thread thread_;
};

}  // namespace darwinop::audio
