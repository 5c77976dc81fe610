// Maps voice names of the 2013 robots and of Webots to those of espeak-ng.
#include "hal/audio/voice_names.hpp"

#include <algorithm>

namespace darwinop::audio {

namespace {
char smallLetter(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}
}  // namespace

std::string voiceOfToday(std::string_view said) {
  const std::size_t end = std::min(said.find('+'), said.size());
  std::string name{said.substr(0, end)};
  std::ranges::transform(name, name.begin(), smallLetter);
  const auto known = std::ranges::find(kVoiceNames, name, &VoiceName::said);
  if (known != kVoiceNames.end()) name = known->today;
  return name.append(said.substr(end));
}

}  // namespace darwinop::audio
