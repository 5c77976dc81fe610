// The loudspeaker: all calls, no sound yet.
#include "webots/Speaker.hpp"

#include "webots/Node.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

namespace {
void warnSilent() {
  darwinop::facade::warnOnce("Speaker: this version has no sound yet; sounds and speech are skipped");
}
}  // namespace

Speaker::Speaker(const std::string& name, darwinop::facade::RobotImpl& robot)
    : Device(name, Node::SPEAKER, robot), language_("en") {}

Speaker::~Speaker() = default;

void Speaker::playSound(Speaker*, Speaker*, const std::string&, double, double, double, bool) {
  warnSilent();
}
void Speaker::stop(const std::string&) {}
bool Speaker::isSoundPlaying(const std::string&) const {
  return false;
}
bool Speaker::isSpeaking() const {
  return false;
}

bool Speaker::setEngine(const std::string& engine) {
  if (engine == getEngine()) return true;
  darwinop::facade::warnOnce("Speaker::setEngine(): the robot has one voice engine, \"" + getEngine() + "\"");
  return false;
}

bool Speaker::setLanguage(const std::string& language) {
  language_ = language;
  return true;
}

std::string Speaker::getEngine() const {
  return "espeak";
}
void Speaker::speak(const std::string&, double) {
  warnSilent();
}

void Speaker::enable(int) {}
void Speaker::disable() {}
void Speaker::playFile(const char*) {
  warnSilent();
}
void Speaker::playFileWait(const char*) {
  warnSilent();
}
void Speaker::speak(const char*, const char*, int) {
  warnSilent();
}
void Speaker::speakFile(const char*, const char*, int) {
  warnSilent();
}

}  // namespace webots
