// webots::Speaker: translates its functions, also those of 2013, to commands for the sound program.
#include "webots/Speaker.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "hal/audio/protocol.hpp"
#include "webots/Node.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/sound_desk.hpp"

namespace webots {

using darwinop::webots_api::warnOnce;

namespace {
constexpr int kSlowest = 80, kFastest = 450;  // words per minute

/// Clamped; a value out of range is reported once. NaN becomes the default.
double within(double low, double value, double high, double usual, const char* what) {
  if (value >= low && value <= high) return value;
  std::ostringstream sentence;
  sentence << "Speaker: a " << what << " lies between " << low << " and " << high << "; it is brought there";
  warnOnce(sentence.str());
  return std::isnan(value) ? usual : std::clamp(value, low, high);
}

std::string given(const char* text) {
  return text != nullptr ? text : "";
}

/// UTF-8 characters have up to four bytes and must not be split.
std::string shortened(std::string text) {
  std::ranges::replace(text, '\0', ' ');
  if (text.size() <= darwinop::audio::kLongestText) return text;
  warnOnce("Speaker: a text of more than 32000 bytes is cut there; speakFile() takes longer ones");
  std::size_t end = darwinop::audio::kLongestText;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  text.resize(end);
  return text;
}
}  // namespace

Speaker::Speaker(const std::string& name, darwinop::webots_api::RobotImpl& robot)
    : Device(name, Node::SPEAKER, robot),
      language_("en"),
      desk_(new darwinop::webots_api::SoundDesk([&robot] { return robot.open_sound(); })) {}

Speaker::~Speaker() {
  delete desk_;
}

void Speaker::refresh() {
  desk_->refresh();
}

// The robot has one loudspeaker: if one side is missing, the other gets both.
void Speaker::playSound(Speaker* left, Speaker* right, const std::string& sound, double volume, double pitch,
                        double balance, bool loop) {
  const Speaker* const speaker = left != nullptr ? left : right;
  if (speaker == nullptr) return warnOnce("Speaker::playSound() without a speaker plays nothing");
  const bool has_sides = left != nullptr && right != nullptr;
  speaker->desk_->play({.id = 0,
                        .file = sound,
                        .volume = within(0, volume, 1, 1, "volume"),
                        .pitch = within(0.5, pitch, 2, 1, "pitch"),
                        .balance = has_sides ? within(-1, balance, 1, 0, "balance") : 0,
                        .loop = loop,
                        .afresh = false});
}

void Speaker::stop(const std::string& sound) {
  desk_->stop(sound);
}

bool Speaker::isSoundPlaying(const std::string& sound) const {
  desk_->refresh();
  return desk_->plays(sound);
}

bool Speaker::isSpeaking() const {
  desk_->refresh();
  return desk_->speaks();
}

bool Speaker::setEngine(const std::string& engine) {
  if (engine == getEngine()) return true;
  warnOnce("Speaker::setEngine(): the robot has one voice engine, \"" + getEngine() + "\"");
  return false;
}

bool Speaker::setLanguage(const std::string& language) {
  if (language.empty()) return false;
  language_ = language;
  return true;
}

std::string Speaker::getEngine() const {
  return "espeak";
}

void Speaker::speak(const std::string& text, double volume) {
  desk_->speak({.id = 0,
                .text = shortened(text),
                .text_is_file = false,
                .voice = language_,
                .volume = within(0, volume, 1, 1, "volume")});
}

void Speaker::enable(int) {}
void Speaker::disable() {}

void Speaker::playFile(const char* filename) {
  desk_->play({.id = 0, .file = given(filename), .afresh = true});
}

/// In lockstep: for the duration of the sound in robot time. Otherwise: until it has ended.
void Speaker::playFileWait(const char* filename) {
  const darwinop::SoundId id = desk_->play({.id = 0, .file = given(filename), .afresh = true});
  const bool lockstep = !robot_.realTime();
  const auto now = [this] { return std::chrono::duration<double>(robot_.session().time()).count(); };
  const double begin = now();
  // Simulated time is not tied to real time: wait for the reply once, so that every run takes the same number of steps.
  std::chrono::milliseconds patience{lockstep ? 2000 : 0};
  double seconds = std::nan("");
  for (;;) {
    if (std::isnan(seconds)) seconds = desk_->seconds(id, std::exchange(patience, std::chrono::milliseconds{0}));
    const bool is_known = !std::isnan(seconds);
    if (lockstep && is_known ? now() >= begin + seconds : !desk_->plays(id)) return;
    // A sound program that hangs must not block the controller.
    if (now() > begin + 10 + (is_known ? seconds : 0)) return desk_->stop(given(filename));
    Robot* const robot = Robot::getInstance();  // its class may walk in an overridden step()
    if (robot == nullptr || robot->step(robot_.config().time_step_ms) == -1) return;
  }
}

void Speaker::speak(const char* text, const char* voice, int speed) {
  desk_->speak({.id = 0,
                .text = shortened(given(text)),
                .text_is_file = false,
                .voice = given(voice),
                .words_per_minute = static_cast<int>(within(kSlowest, speed, kFastest, 175, "speed"))});
}

void Speaker::speakFile(const char* filename, const char* voice, int speed) {
  desk_->speak({.id = 0,
                .text = given(filename),
                .text_is_file = true,
                .voice = given(voice),
                .words_per_minute = static_cast<int>(within(kSlowest, speed, kFastest, 175, "speed"))});
}

}  // namespace webots
