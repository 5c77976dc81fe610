#include "window/driver.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace darwinop::window {
namespace {

void answer(web::Channel& channel, bool yours, const std::string& text, bool taking = false) {
  const nlohmann::json said{{"type", "driving"}, {"yours", yours}, {"taking", taking}, {"text", text}};
  const auto replace = nlohmann::json::error_handler_t::replace;
  channel.send(web::kEvery, std::make_shared<const std::string>(said.dump(-1, ' ', false, replace)));
}

}  // namespace

Driver::~Driver() {
  if (driver_ != nullptr) helm_.leave();
}

void Driver::opened(web::Channel& channel) {
  answer(channel, false, "");
}

void Driver::said(web::Channel& channel, std::string_view message, bool binary) {
  std::string why = "only text is understood here";
  const std::optional<SteeringWords> words = binary ? std::nullopt : readSteering(message, why);
  if (!words) return answer(channel, at_helm_ && driver_ == &channel, why);  // does not count as a sign of life
  if (words->take && driver_ == nullptr)
    take(channel);
  else if (words->take && driver_ != &channel)
    answer(channel, false, "another page drives");
  if (driver_ != &channel) return;
  heard_ = clock_();
  if (words->stop) {
    helm_.stop();
    return letGo("You have let go. The robot holds.");
  }
  if (words->leave) {
    helm_.leave();
    return letGo("You have let go. The robot holds.");
  }
  orders_.add(words->orders);
}

void Driver::take(web::Channel& channel) {
  const Helm::State state = helm_.report().state;
  if (state != Helm::State::kFree) return answer(channel, false, "the robot is still coming to rest; try again");
  driver_ = &channel;
  at_helm_ = false;
  orders_ = {};
  told_ = {};
  answer(channel, false, "Taking the robot …", true);
  helm_.begin();
}

void Driver::turn() {
  if (driver_ == nullptr) return;
  const Helm::Report report = helm_.report();
  if (report.state == Helm::State::kFree || (at_helm_ && report.state == Helm::State::kEnding))
    return letGo(report.why);
  if (!at_helm_ && report.state == Helm::State::kDriving) {
    at_helm_ = true;
    heard_ = clock_();  // it was told nothing to answer yet
    answer(*driver_, true, "");
  }
  if (!at_helm_) return;
  if (clock_() - heard_ > kPatience) {
    helm_.leave();
    return letGo("This page was not heard for half a second. The robot holds.");
  }
  helm_.order(orders_);
  orders_.taken();
  if (report.doings != told_) tellDoings(report.doings);
}

void Driver::tellDoings(const Doings& doings) {
  told_ = doings;
  nlohmann::json limp = nlohmann::json::array();
  for (std::size_t i = 0; i < kLimbs; ++i)
    if (doings.limp[i]) limp.push_back(limbName(i));
  const nlohmann::json said{
      {"type", "doing"}, {"walks", doings.walks}, {"page", doings.page}, {"limp", limp}, {"refused", doings.refused}};
  driver_->send(web::kEvery, std::make_shared<const std::string>(said.dump()));
}

void Driver::letGo(const std::string& why) {
  at_helm_ = false;
  answer(*std::exchange(driver_, nullptr), false, why);
}

void Driver::closed(web::Channel& channel) noexcept {
  if (driver_ != &channel) return;
  driver_ = nullptr;
  at_helm_ = false;
  helm_.leave();
}

}  // namespace darwinop::window
