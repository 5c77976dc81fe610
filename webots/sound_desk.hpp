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

/// Used by one thread. Errors are reported once and are not fatal.
class SoundDesk {
 public:
  /// `open` is called at the first command, and again after the output was lost.
  explicit SoundDesk(std::function<std::unique_ptr<SoundOutput>()> open) : open_{std::move(open)} {}

  /// Sends the command with a new id and the file's absolute path; returns the id, 0: there is no sound output.
  SoundId play(PlaySound play);
  void speak(Speak speak);
  /// Stops a file; empty: everything.
  void stop(const std::string& file);

  /// Processes received events; does not block.
  void refresh() { takeEvents(std::chrono::milliseconds{0}); }
  /// True if the file is playing; empty: if any is.
  [[nodiscard]] bool plays(const std::string& file) const;
  [[nodiscard]] bool plays(SoundId id) const;
  [[nodiscard]] bool speaks() const { return speech_ != 0; }
  /// Duration of a sound, s; 0: it has ended, NaN: unknown. Waits for a reply.
  [[nodiscard]] double seconds(SoundId id, std::chrono::milliseconds wait);

 private:
  struct Sound {
    SoundId id;
    std::optional<double> seconds;  // known once it has started
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
