// Playback thread: mixes in blocks and writes them to the card in real time.
#include "hal/audio/program/player.hpp"

#include <array>
#include <exception>

namespace darwinop::audio {

namespace {
using namespace std::chrono_literals;

constexpr std::size_t kPiece = 1024;  // frames: 23 ms
// Blocks are mixed this far ahead of playback: the latency of a stop, and the tolerated scheduling delay.
constexpr auto kLead = 120ms;
constexpr auto kRest = 300ms;  // after this much silence the card is closed

constexpr std::chrono::nanoseconds timeOf(std::uint64_t frames) {
  return std::chrono::nanoseconds{frames * 1'000'000'000 / kMixRate};
}
}  // namespace

SoundPlayer::SoundPlayer(std::function<void(const SoundEvent&)> report)
    : report_{std::move(report)}, thread_{[this] { run(); }} {}

SoundPlayer::~SoundPlayer() {
  {
    const std::lock_guard lock{mutex_};
    ending_ = true;
    changed_.notify_one();
  }
  thread_.join();
}

void SoundPlayer::run() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [this] { return ending_ || !mixer_.idle(); });
      if (ending_) return;
    }
    sound();
  }
}

/// Plays from the first sound until silence.
void SoundPlayer::sound() {
  std::unique_ptr<Card> card;
  try {
    card = openCard();
  } catch (const std::exception& error) {
    report_(SoundError{error.what()});
  }
  const Clock::time_point began = Clock::now();
  std::array<Sample, kPiece> piece;
  std::uint64_t written = 0, last_audible = 0;
  for (;;) {
    {
      const std::lock_guard lock{mutex_};
      if (ending_) return;
      mixer_.mix(piece);
      written += kPiece;
      if (!mixer_.silent()) last_audible = written;
      for (const SoundId id : mixer_.takeEnded()) ended_.push_back({began + timeOf(written), id});
    }
    write(card, piece);
    std::this_thread::sleep_until(began + timeOf(written) - kLead);
    reportEnded(Clock::now());
    // An empty text ends without a sound; its end must be reported as well.
    if (timeOf(written - last_audible) > kRest && ended_.empty()) break;
  }
}

/// If the card is removed, the remaining sounds end at their usual time, without output.
void SoundPlayer::write(std::unique_ptr<Card>& card, std::span<const Sample> piece) {
  if (!card) return;
  try {
    card->write(piece);
  } catch (const std::exception& error) {
    card.reset();
    report_(SoundError{error.what()});
  }
}

void SoundPlayer::reportEnded(Clock::time_point played_at) {
  for (; !ended_.empty() && ended_.front().played_at <= played_at; ended_.pop_front())
    report_(SoundEnded{ended_.front().id});
}

}  // namespace darwinop::audio
