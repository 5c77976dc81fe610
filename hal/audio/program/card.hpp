// Where the mix goes: a sound card through ALSA, or nowhere, in the same time.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/audio/mixer.hpp"

namespace darwinop::audio {

class Card {
 public:
  virtual ~Card() = default;
  /// May wait until there is room. Throws std::runtime_error when the card has gone.
  virtual void write(std::span<const Sample> samples) = 0;
};

/// DARWINOP_SOUND_CARD, or ALSA's "default". Throws std::runtime_error that says why it cannot be had.
std::unique_ptr<Card> openCard();

/// What must be done before the process ends: ALSA keeps what it read.
void forgetCards();

}  // namespace darwinop::audio
