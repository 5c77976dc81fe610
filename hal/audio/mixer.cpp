// Mixes all active sounds into one stereo stream.
#include "hal/audio/mixer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace darwinop::audio {

namespace {
std::int16_t sixteenBits(float value) {
  return static_cast<std::int16_t>(std::lrint(std::clamp(value, -1.0F, 1.0F) * 32767.0F));
}

TrackSetting settingOf(const PlaySound& play) {
  return {.volume = play.volume, .pitch = play.pitch, .balance = play.balance, .loop = play.loop};
}
}  // namespace

template <class Condition>
void Mixer::end(Condition which) {
  for (auto sound = sounds_.begin(); sound != sounds_.end();) {
    if (!which(*sound)) {
      ++sound;
      continue;
    }
    ended_.push_back(sound->id);
    sound = sounds_.erase(sound);
  }
}

bool Mixer::change(const PlaySound& play) {
  if (play.afresh) return false;
  const auto same =
      std::ranges::find_if(sounds_, [&](const Sound& sound) { return !sound.afresh && sound.file == play.file; });
  if (same == sounds_.end()) return false;
  ended_.push_back(std::exchange(same->id, play.id));
  same->track.set(settingOf(play));
  return true;
}

bool Mixer::play(const PlaySound& play, std::unique_ptr<SoundSource> source) {
  if (play.afresh) end([](const Sound& sound) { return sound.afresh; });
  if (sounds_.size() >= kMostSounds) return false;
  sounds_.push_back({play.id, play.file, play.afresh, Track{std::move(source), kMixRate}});
  sounds_.back().track.set(settingOf(play));
  return true;
}

void Mixer::speak(const Speak& speak, std::unique_ptr<SoundSource> voice) {
  end([](const Sound& sound) { return sound.file.empty(); });
  sounds_.push_back({speak.id, "", false, Track{std::move(voice), kMixRate}});
  sounds_.back().track.set({.volume = speak.volume});
}

void Mixer::stop(const StopSound& stop) {
  end([&](const Sound& sound) { return stop.file.empty() || sound.file == stop.file; });
}

void Mixer::mix(std::span<Sample> out) {
  sum_.assign(out.size(), AudioFrame{});
  end([&](Sound& sound) { return !sound.track.addTo(sum_); });
  std::ranges::transform(sum_, out.begin(), [](const AudioFrame& sum) {
    return Sample{sixteenBits(sum.left), sixteenBits(sum.right)};
  });
}

std::vector<SoundId> Mixer::takeEnded() {
  return std::exchange(ended_, {});
}

}  // namespace darwinop::audio
