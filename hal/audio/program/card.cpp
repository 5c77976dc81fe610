// Audio output: an ALSA sound card.
#include "hal/audio/program/card.hpp"

#include <alsa/asoundlib.h>

#include <cstdarg>
#include <cstdlib>
#include <stdexcept>

namespace darwinop::audio {

namespace {

constexpr unsigned kLatencyUs = 200'000;  // ALSA buffer; tolerates this scheduling delay on the robot's Atom

/// Without this handler, ALSA prints diagnostics to the controller's standard error.
void discardAlsaMessage(const char*, int, const char*, int, const char*, ...) {}

struct ClosePcm {
  void operator()(snd_pcm_t* pcm) const {
    snd_pcm_drop(pcm);
    snd_pcm_close(pcm);
  }
};

class AlsaCard final : public Card {
 public:
  explicit AlsaCard(const std::string& name) : name_{name} {
    snd_lib_error_set_handler(discardAlsaMessage);
    snd_pcm_t* pcm = nullptr;
    // Non-blocking: if another program has the card open, fail at once.
    check(snd_pcm_open(&pcm, name.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK));
    pcm_.reset(pcm);
    check(snd_pcm_nonblock(pcm, 0));
    check(snd_pcm_set_params(pcm, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 2, kMixRate, 1, kLatencyUs));
  }

  void write(std::span<const Sample> samples) override {
    while (!samples.empty()) {
      const snd_pcm_sframes_t count = snd_pcm_writei(pcm_.get(), samples.data(), samples.size());
      if (count < 0)
        check(snd_pcm_recover(pcm_.get(), static_cast<int>(count), 1));  // recovers from an underrun
      else
        samples = samples.subspan(static_cast<std::size_t>(count));
    }
    // ALSA would otherwise start playback only when its buffer is full.
    if (snd_pcm_state(pcm_.get()) == SND_PCM_STATE_PREPARED) snd_pcm_start(pcm_.get());
  }

 private:
  void check(int result) const {
    if (result < 0)
      throw std::runtime_error("cannot use sound card \"" + name_ + "\": " + snd_strerror(result) +
                               "; sounds keep their duration but are silent; see docs/sound.md");
  }

  std::string name_;
  std::unique_ptr<snd_pcm_t, ClosePcm> pcm_;
};

}  // namespace

std::unique_ptr<Card> openCard() {
  const char* const name = std::getenv("DARWINOP_SOUND_CARD");
  return std::make_unique<AlsaCard>(name != nullptr && *name != '\0' ? name : "default");
}

void forgetCards() {
  snd_config_update_free_global();
}

}  // namespace darwinop::audio
