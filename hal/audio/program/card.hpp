// Audio output: an ALSA sound card.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/audio/mixer.hpp"

namespace darwinop::audio {

class Card {
 public:
  virtual ~Card() = default;
  /// Blocks until the buffer has room. Throws std::runtime_error if the card was removed.
  virtual void write(std::span<const Sample> samples) = 0;
};

/// DARWINOP_SOUND_CARD, or ALSA's "default". Throws std::runtime_error if it cannot be opened.
std::unique_ptr<Card> openCard();

/// Frees ALSA's cached configuration before the process ends.
void forgetCards();

}  // namespace darwinop::audio
