// State of a controller's sounds and speech, from the events received so far.
#include "webots/sound_desk.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>

#include "webots/notices.hpp"

namespace darwinop::webots_api {

namespace {
/// Absolute path, from the controller's present working directory: the sound program has its own.
std::string absoluteName(const std::string& file) {
  std::error_code unknown;
  const std::string absolute = std::filesystem::absolute(file, unknown);
  return unknown ? file : absolute;
}
}  // namespace

bool SoundDesk::order(const SoundOrder& order) {
  refresh();
  try {
    if (!output_) output_ = open_();
  } catch (const std::exception& error) {
    warnOnce(std::string{"Speaker: sounds and speech are skipped: "} + error.what());
    return false;
  }
  if (output_->order(order)) return true;
  warnOnce("Speaker: too many orders at once, some are left out");
  return false;
}

SoundId SoundDesk::play(PlaySound play) {
  const std::string file = play.file;
  play.id = ++last_;
  play.file = absoluteName(file);
  if (!order(play)) return 0;
  sounds_[file] = {.id = play.id, .seconds = {}};
  return play.id;
}

void SoundDesk::speak(Speak speak) {
  speak.id = ++last_;
  if (speak.text_is_file) speak.text = absoluteName(speak.text);
  if (order(speak)) speech_ = speak.id;
}

void SoundDesk::stop(const std::string& file) {
  refresh();
  if (!output_) return;  // no sound was played
  order(StopSound{file.empty() ? "" : absoluteName(file)});
  if (!file.empty()) {
    sounds_.erase(file);
    return;
  }
  sounds_.clear();
  speech_ = 0;
}

bool SoundDesk::plays(const std::string& file) const {
  return file.empty() ? !sounds_.empty() : sounds_.contains(file);
}

bool SoundDesk::plays(SoundId id) const {
  return std::ranges::any_of(sounds_, [id](const auto& sound) { return sound.second.id == id; });
}

double SoundDesk::seconds(SoundId id, std::chrono::milliseconds wait) {
  const auto end = std::chrono::steady_clock::now() + wait;
  for (;;) {
    const auto found = std::ranges::find_if(sounds_, [id](const auto& sound) { return sound.second.id == id; });
    if (found == sounds_.end()) return 0;
    if (found->second.seconds) return *found->second.seconds;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return std::numeric_limits<double>::quiet_NaN();
    takeEvents(left);
  }
}

void SoundDesk::takeEvents(std::chrono::milliseconds wait) {
  if (!output_) return;
  while (const auto event = output_->nextEvent(wait)) {
    std::visit([this](const auto& one) { take(one); }, *event);
    wait = {};
  }
  if (lost_) output_.reset();
  lost_ = false;
}

void SoundDesk::take(const SoundStarted& started) {
  for (auto& [file, sound] : sounds_)
    if (sound.id == started.id) sound.seconds = started.seconds;
}

void SoundDesk::take(const SoundEnded& ended) {
  std::erase_if(sounds_, [&](const auto& sound) { return sound.second.id == ended.id; });
  if (speech_ == ended.id) speech_ = 0;
}

void SoundDesk::take(const SoundError& error) {
  warnOnce("Speaker: " + error.sentence);
}

void SoundDesk::take(const SoundLost& lost) {
  warnOnce("Speaker: " + lost.sentence);
  sounds_.clear();
  speech_ = 0;
  lost_ = true;
}

}  // namespace darwinop::webots_api
