// State of a controller's sounds and speech, from the events received so far.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hal/sound_output.hpp"

namespace darwinop::webots_api {

/// Used by one thread. Errors are reported once and end nothing.
class SoundDesk {
 public:
  /// `open` is called at the first order, and again after an output was lost.
  explicit SoundDesk(std::function<std::unique_ptr<SoundOutput>()> open) : open_{std::move(open)} {}

  /// Gives the order a name and its file a place; 0: there is no sound.
  SoundId play(PlaySound play);
  void speak(Speak speak);
  /// Empty: everything.
  void stop(const std::string& file);

  /// Takes the events received, without waiting.
  void refresh() { takeEvents(std::chrono::milliseconds{0}); }
  /// Empty: is there any?
  [[nodiscard]] bool plays(const std::string& file) const;
  [[nodiscard]] bool plays(SoundId id) const;
  [[nodiscard]] bool speaks() const { return speech_ != 0; }
  /// How long it takes from its beginning to its end; 0: it has ended, NaN: unknown. Waits for an answer.
  [[nodiscard]] double seconds(SoundId id, std::chrono::milliseconds wait);

 private:
  struct Sound {
    SoundId id;
    std::optional<double> seconds;  // once it has begun
  };
  bool order(const SoundOrder& order);
  void takeEvents(std::chrono::milliseconds wait);
  void take(const SoundStarted& started);
  void take(const SoundEnded& ended);
  void take(const SoundError& error);
  void take(const SoundLost& lost);

  std::function<std::unique_ptr<SoundOutput>()> open_;
  std::unique_ptr<SoundOutput> output_;
  bool lost_ = false;
  SoundId last_ = 0;
  SoundId speech_ = 0;
  std::map<std::string, Sound> sounds_;  // by file
};

}  // namespace darwinop::webots_api
