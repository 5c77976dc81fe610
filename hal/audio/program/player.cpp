// The thread that mixes and feeds the card, at the pace of real time.
#include "hal/audio/program/player.hpp"

#include <array>
#include <exception>

namespace darwinop::audio {

namespace {
using namespace std::chrono_literals;

constexpr std::size_t kPiece = 1024;  // frames: 23 ms
// So far ahead of what is heard: a stop is heard that much later, and a busy computer may be late by as much.
constexpr auto kLead = 120ms;
constexpr auto kRest = 300ms;  // silence after which the card is free for others

constexpr std::chrono::nanoseconds timeOf(std::uint64_t frames) {
  return std::chrono::nanoseconds{frames * 1'000'000'000 / kMixRate};
}
}  // namespace

Player::Player(std::function<void(const SoundNews&)> tell) : tell_{std::move(tell)}, thread_{[this] { run(); }} {}

Player::~Player() {
  {
    const std::lock_guard lock{mutex_};
    ending_ = true;
    changed_.notify_one();
  }
  thread_.join();
}

void Player::run() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [this] { return ending_ || !mixer_.idle(); });
      if (ending_) return;
    }
    sound();
  }
}

/// From the first sound to silence.
void Player::sound() {
  std::unique_ptr<Card> card;
  try {
    card = openCard();
  } catch (const std::exception& error) {
    tell_(SoundTrouble{error.what()});
  }
  const Clock::time_point began = Clock::now();
  std::array<Sample, kPiece> piece;
  std::uint64_t written = 0, last_heard = 0;
  for (;;) {
    {
      const std::lock_guard lock{mutex_};
      if (ending_) return;
      mixer_.mix(piece);
      written += kPiece;
      if (!mixer_.silent()) last_heard = written;
      for (const SoundId id : mixer_.takeEnded()) ended_.push_back({began + timeOf(written), id});
    }
    write(card, piece);
    std::this_thread::sleep_until(began + timeOf(written) - kLead);
    tellEnded(Clock::now());
    // What ended without a sound, an empty text, is not told later than the rest.
    if (timeOf(written - last_heard) > kRest && ended_.empty()) break;
  }
}

/// A card that is pulled out leaves the rest of the sounds unheard, not unfinished.
void Player::write(std::unique_ptr<Card>& card, std::span<const Sample> piece) {
  if (!card) return;
  try {
    card->write(piece);
  } catch (const std::exception& error) {
    card.reset();
    tell_(SoundTrouble{error.what()});
  }
}

void Player::tellEnded(Clock::time_point heard) {
  for (; !ended_.empty() && ended_.front().heard <= heard; ended_.pop_front()) tell_(SoundEnded{ended_.front().id});
}

}  // namespace darwinop::audio
