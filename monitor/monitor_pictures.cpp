// Publishes pictures and search results to subscribers.
#include <algorithm>
#include <utility>

#include "monitor/lanes.hpp"
#include "monitor/messages.hpp"
#include "monitor/monitor.hpp"
#include "monitor/picture.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::monitor {
namespace {

constexpr double kDriverLooks = 20;  // Hz

}  // namespace

void Monitor::publishPictures() {
  if (std::exchange(searches_changed_, false)) updateSearches();
  const auto requests = [](const auto& subscriber) { return subscriber.second.subscription.camera > 0; };
  const bool wanted = std::ranges::any_of(subscribers_, requests);
  const bool runs = runtime_.block() != nullptr;
  if (wanted && runs && driver_pace_.due(now_, kDriverLooks)) driver_ = runtime_.driver();
  camera_.update(wanted && runs, driver_ == 0 || driver_ == own_driver_, now_);
  if (!wanted) return;
  const remote::JpegPicture picture = camera_.newest();
  web::Bytes message;
  for (auto& [channel, subscriber] : subscribers_) {
    if (subscriber.subscription.camera <= 0) continue;
    sendCameraStatus(*channel, subscriber, picture.sequence != 0);
    if (picture.sequence == 0 || picture.sequence == subscriber.picture) continue;
    if (!subscriber.pictures.due(now_, subscriber.subscription.camera)) continue;
    if (!message) message = shared(pictureMessage(picture, remote::kWholeImage));
    subscriber.picture = picture.sequence;
    // The result precedes its picture, so that a page can show both together.
    if (search_ && subscriber.subscription.find)
      if (const std::optional<ColourMatch> found = search_->resultOf(*subscriber.subscription.find, picture.sequence))
        channel->send(kFoundLane, shared(colourMatchText(*found, subscriber.subscription.mask)));
    channel->sendBinary(kPictureLane, message);
  }
}

void Monitor::updateSearches() {
  if (!search_) return;
  std::vector<ColourQuery> searches;
  for (const auto& [channel, subscriber] : subscribers_)
    if (subscriber.subscription.camera > 0 && subscriber.subscription.find)
      searches.push_back(*subscriber.subscription.find);
  search_->setSearches(searches);
}

void Monitor::sendCameraStatus(web::Channel& channel, Subscriber& subscriber, bool seeing) {
  std::string text;
  if (runtime_.block() == nullptr)
    text = cameraText(false, "no runtime is running");
  else if (const std::string why = camera_.why(); !why.empty())
    text = cameraText(false, why);
  else
    text = cameraText(seeing, seeing ? "" : camera_.shared() ? kNoSharedPictures : kCameraIsBlind);
  if (text == subscriber.camera) return;
  subscriber.camera = text;
  channel.send(kCameraLane, shared(std::move(text)));
}

}  // namespace darwinop::monitor
