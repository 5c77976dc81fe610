#include "window/driver.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "remote/protocol/units.hpp"

namespace darwinop::window {
namespace {

void answer(web::Channel& channel, bool yours, const std::string& text) {
  const nlohmann::json said{{"type", "driving"}, {"yours", yours}, {"text", text}};
  const auto replace = nlohmann::json::error_handler_t::replace;
  channel.send(web::kEvery, std::make_shared<const std::string>(said.dump(-1, ' ', false, replace)));
}

remote::MotorSetting goalFor(Joint joint, Rad goal) {
  remote::MotorSetting setting;
  setting.joint = joint;
  setting.set = remote::MotorSetting::kPosition | remote::MotorSetting::kVelocity;
  setting.position = std::clamp(remote::wireFromPosition(std::clamp(goal.value, -kPi, kPi)), -2048, 2047);
  setting.velocity = remote::wireFromVelocity(Driver::kFastest);
  return setting;
}

}  // namespace

Driver::~Driver() {
  if (driver_ != nullptr) robot_.hold();
}

void Driver::opened(web::Channel& channel) {
  answer(channel, false, "");
}

void Driver::said(web::Channel& channel, std::string_view message, bool binary) {
  std::string why = "only text is understood here";
  const std::optional<SteeringWords> words = binary ? std::nullopt : readSteering(message, why);
  if (!words) return answer(channel, driver_ == &channel, why);  // does not count as a sign of life
  if (words->take && driver_ == nullptr)
    take(channel);
  else if (words->take && driver_ != &channel)
    answer(channel, false, "another page drives");
  if (driver_ != &channel) return;
  heard_ = clock_();
  if (words->stop) return letGo("You have let go. The robot holds.");
  for (const auto& [joint, goal] : words->goals) goals_[index(joint)] = goal;
}

void Driver::take(web::Channel& channel) {
  try {
    robot_.begin(remote::Beginning::kFresh);
  } catch (const std::runtime_error& error) {
    return answer(channel, false, error.what());
  }
  driver_ = &channel;
  goals_ = {};
  answer(channel, true, "");
}

void Driver::turn() {
  if (driver_ == nullptr) return;
  if (clock_() - heard_ > kPatience) return letGo("This page was not heard for half a second. The robot holds.");
  if (const std::string why = robot_.mustEnd(); !why.empty()) return letGo(why);
  remote::Request request;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (goals_[i]) request.motors.add(goalFor(static_cast<Joint>(i), *goals_[i]));
  goals_ = {};
  robot_.obey(request);
}

void Driver::letGo(const std::string& why) {
  robot_.hold();
  answer(*std::exchange(driver_, nullptr), false, why);
}

void Driver::closed(web::Channel& channel) noexcept {
  if (driver_ != &channel) return;
  driver_ = nullptr;
  robot_.hold();
}

}  // namespace darwinop::window
