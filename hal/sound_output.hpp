// Interface of a loudspeaker: commands to it and events from it.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace darwinop {

/// Chosen by the caller; used once.
using SoundId = std::uint32_t;

struct PlaySound {
  SoundId id = 0;
  std::string file = {};  // absolute
  double volume = 1;      // 0 to 1
  double pitch = 1;       // 0.5 to 2: one octave down to one up; also changes the duration
  double balance = 0;     // -1: left only, 1: right only
  bool loop = false;
  /// True: restart from the beginning and replace the last one played so. False: a file that is already playing
  /// continues with these parameters and this id.
  bool afresh = false;
  bool operator==(const PlaySound&) const = default;
};

/// Aborts the current speech.
struct Speak {
  SoundId id = 0;
  std::string text = {};  // UTF-8 (or Latin-1), or the absolute path of a text file
  bool text_is_file = false;
  std::string voice = "en";    // as in docs/sound.md
  int words_per_minute = 175;  // 80 to 450
  double volume = 1;           // 0 to 1
  bool operator==(const Speak&) const = default;
};

struct StopSound {
  std::string file = {};  // empty: all sounds and speech
  bool operator==(const StopSound&) const = default;
};

using SoundOrder = std::variant<PlaySound, Speak, StopSound>;

/// Playback has started; `seconds`: its duration, NaN: unknown.
struct SoundStarted {
  SoundId id = 0;
  double seconds = 0;
  bool operator==(const SoundStarted&) const = default;
};
/// Played to the end, stopped, or not playable.
struct SoundEnded {
  SoundId id = 0;
  bool operator==(const SoundEnded&) const = default;
};
/// An error message for the user; playback of other sounds continues.
struct SoundError {
  std::string sentence = {};
  bool operator==(const SoundError&) const = default;
};
/// The last event: all sounds have ended and no command is accepted any more. Create a new output.
struct SoundLost {
  std::string sentence = {};
  bool operator==(const SoundLost&) const = default;
};

using SoundEvent = std::variant<SoundStarted, SoundEnded, SoundError, SoundLost>;

/// Used by one thread.
class SoundOutput {
 public:
  virtual ~SoundOutput() = default;
  /// Does not block. Returns false if the output is lost or too many commands are queued.
  virtual bool order(const SoundOrder& order) = 0;
  /// The next event; waits at most `wait`.
  virtual std::optional<SoundEvent> nextEvent(std::chrono::milliseconds wait) = 0;
};

}  // namespace darwinop
