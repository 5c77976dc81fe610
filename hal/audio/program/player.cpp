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
constexpr auto kRetry = 1s;    // a card that is in use or unplugged is tried again, for a sound that repeats

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
  openTheCard();
  playUntilSilence();
  card_.reset();
}

void SoundPlayer::openTheCard() {
  tried_ = Clock::now();
  try {
    card_ = openCard();
    card_error_.clear();
  } catch (const std::exception& error) {
    reportCard(error.what());
  }
}

/// Reports an error once as long as it stays the same.
void SoundPlayer::reportCard(const std::string& error) {
  if (error != card_error_) report_(SoundError{error});
  card_error_ = error;
}

void SoundPlayer::playUntilSilence() {
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
    write(piece);
    std::this_thread::sleep_until(began + timeOf(written) - kLead);
    reportEnded(Clock::now());
    // An empty text ends without a sound; its end must be reported as well.
    if (timeOf(written - last_audible) > kRest && ended_.empty()) break;
  }
}

/// Without a card, sounds end at their usual time, without output.
void SoundPlayer::write(std::span<const Sample> piece) {
  if (!card_ && Clock::now() - tried_ >= kRetry) openTheCard();
  if (!card_) return;
  try {
    card_->write(piece);
  } catch (const std::exception& error) {
    card_.reset();
    reportCard(error.what());
  }
}

void SoundPlayer::reportEnded(Clock::time_point played_at) {
  for (; !ended_.empty() && ended_.front().played_at <= played_at; ended_.pop_front())
    report_(SoundEnded{ended_.front().id});
}

}  // namespace darwinop::audio
