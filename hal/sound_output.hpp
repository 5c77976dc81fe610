// Orders to a loudspeaker and the news that come back: whatever it is that sounds.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace darwinop {

/// Sounds and speech have names given by who orders them; a name is used once.
using SoundId = std::uint32_t;

struct PlaySound {
  SoundId id = 0;
  std::string file = {};  // absolute
  double volume = 1;      // 0 to 1
  double pitch = 1;       // 0.5 to 2: an octave lower, an octave higher; the sound gets longer, shorter
  double balance = 0;     // -1: left only, 1: right only
  bool loop = false;
  /// From its beginning and instead of the last one that was played so. Otherwise a file that sounds already goes on,
  /// with these values and this name.
  bool afresh = false;
  bool operator==(const PlaySound&) const = default;
};

/// Ends what is being spoken.
struct Speak {
  SoundId id = 0;
  std::string text = {};  // UTF-8 (or Latin-1), or the absolute name of a file that has it
  bool text_is_file = false;
  std::string voice = "en";    // as in docs/sound.md
  int words_per_minute = 175;  // 80 to 450
  double volume = 1;           // 0 to 1
  bool operator==(const Speak&) const = default;
};

struct StopSound {
  std::string file = {};  // empty: every sound, and speech
  bool operator==(const StopSound&) const = default;
};

using SoundOrder = std::variant<PlaySound, Speak, StopSound>;

/// It was found and can be played; `seconds` it will take, NaN: nobody knows.
struct SoundStarted {
  SoundId id = 0;
  double seconds = 0;
  bool operator==(const SoundStarted&) const = default;
};
/// It has been heard to its end, was stopped, or could not be played.
struct SoundEnded {
  SoundId id = 0;
  bool operator==(const SoundEnded&) const = default;
};
/// A sentence for the user; the rest goes on.
struct SoundTrouble {
  std::string sentence = {};
  bool operator==(const SoundTrouble&) const = default;
};
/// The last news: everything has ended, and nothing can be ordered any more. A new output can.
struct SoundLost {
  std::string sentence = {};
  bool operator==(const SoundLost&) const = default;
};

using SoundNews = std::variant<SoundStarted, SoundEnded, SoundTrouble, SoundLost>;

/// Used by one thread.
class SoundOutput {
 public:
  virtual ~SoundOutput() = default;
  /// Does not wait. False: it is lost, too many are waiting already.
  virtual bool order(const SoundOrder& order) = 0;
  /// The next news; waits for one for so long.
  virtual std::optional<SoundNews> news(std::chrono::milliseconds wait) = 0;
};

}  // namespace darwinop
