// Publishes state, faults and loop statistics to subscribers.
#include "monitor/monitor.hpp"

#include <algorithm>
#include <utility>

#include "monitor/lanes.hpp"
#include "monitor/messages.hpp"

namespace darwinop::monitor {
namespace {

constexpr double kFaultLooks = 10;  // Hz
constexpr Nanos kShortest{4'000'000}, kLongest{50'000'000}, kIdle{100'000'000};

double secondsOf(Nanos time) {
  return std::chrono::duration<double>{time}.count();
}

}  // namespace

Monitor::Monitor(const runtime::RuntimeFiles& files, Clock clock, CameraSource::Open open_camera,
                 CameraSource::Open share_camera, std::shared_ptr<ColourSearch> search)
    : runtime_{files},
      clock_{std::move(clock)},
      camera_{std::move(open_camera), std::move(share_camera)},
      search_{std::move(search)} {
  now_ = clock_();
  (void)runtime_.update(now_);
  resetForRuntime();
}

void Monitor::opened(web::Channel& channel) {
  const Subscriber& subscriber = subscribers_[&channel];
  channel.send(kHelloLane, shared(helloText(runtime_.block() != nullptr ? &runtime_.block()->info : nullptr,
                                            subscriber.subscription)));
  sendRuntimeStatus(channel);
  for (const web::Bytes& notice : notices_) channel.send(web::kEvery, notice);
}

void Monitor::sendRuntimeStatus(web::Channel& channel) {
  if (runtime_.block() == nullptr)
    channel.send(kGoneLane, shared(goneText(runtime_.reason())));
  else
    channel.send(kFaultsLane, shared(faults_text_));
}

void Monitor::received(web::Channel& channel, std::string_view message, bool binary) {
  const auto subscriber = subscribers_.find(&channel);
  if (subscriber == subscribers_.end()) return;
  std::string why = "requests must be text messages";
  const std::optional<Subscription> subscription =
      binary ? std::nullopt : parseSubscription(message, subscriber->second.subscription, why);
  if (!subscription) return channel.send(kErrorLane, shared(errorText(why)));
  searches_changed_ |= subscription->find != subscriber->second.subscription.find ||
                       subscription->camera != subscriber->second.subscription.camera;
  subscriber->second.subscription = *subscription;
  subscriber->second.state.restart();
  subscriber->second.pictures.restart();
  if (subscription->camera == 0) subscriber->second.camera.clear();
}

void Monitor::notice(const std::string& text) {
  const double time =
      runtime_.block() != nullptr && seen_.cycle > 0 ? static_cast<double>(seen_.time_ns) * 1e-9 : kUnknown;
  notices_.push_back(shared(noticeText(++notice_number_, time, text)));
  if (notices_.size() > kNotices) notices_.pop_front();
  for (const auto& [channel, subscriber] : subscribers_) channel->send(web::kEvery, notices_.back());
}

Nanos Monitor::pause() const {
  if (subscribers_.empty()) return kIdle;
  double most = 0;
  for (const auto& [channel, subscriber] : subscribers_)
    most = std::max({most, subscriber.subscription.rate, subscriber.subscription.camera});
  if (most <= 0) return kLongest;
  return std::clamp(periodOf(most) / 2, kShortest, kLongest);
}

void Monitor::update() {
  now_ = clock_();
  if (runtime_.update(now_)) {
    resetForRuntime();
    const runtime::ExchangeBlock* const block = runtime_.block();
    notice(block == nullptr ? runtime_.reason() : "a runtime has started, pid " + std::to_string(block->info.pid));
  }
  if (runtime_.block() != nullptr) {
    (void)runtime_.block()->sensors.read(seen_);  // keeps the previous image if the loop overwrote it while reading
    publishState();
    publishFaults();
    publishLoopStats();
  }
  publishPictures();
}

/// A runtime has started or ended, or the reason why there is none has changed.
void Monitor::resetForRuntime() {
  seen_ = {};
  state_text_.reset();
  state_cycle_ = 0;
  figures_any_ = false;
  announced_.str({});
  announcer_ = std::make_unique<runtime::FaultAnnouncer>(announced_);
  faults_text_ = faultsText({});
  driver_ = 0;
  const runtime::ExchangeBlock* const block = runtime_.block();
  for (auto& [channel, subscriber] : subscribers_) {
    channel->discardQueued();  // queued messages describe the previous runtime
    if (block != nullptr) channel->send(kHelloLane, shared(helloText(&block->info, subscriber.subscription)));
    sendRuntimeStatus(*channel);
    subscriber.cycle = 0;
    subscriber.camera.clear();
    subscriber.state.restart();
  }
}

bool Monitor::everyCycle(const Subscriber& subscriber) const {
  constexpr double kNearly = 0.99;  // 62.5 Hz at 16 ms: a separate timer would skip a cycle now and then
  return subscriber.subscription.rate > 0 &&
         subscriber.subscription.rate * static_cast<double>(seen_.period_ns) * 1e-9 >= kNearly;
}

void Monitor::publishState() {
  if (seen_.cycle == 0) return;
  for (auto& [channel, subscriber] : subscribers_) {
    if (subscriber.cycle == seen_.cycle) continue;
    if (!everyCycle(subscriber) && !subscriber.state.due(now_, subscriber.subscription.rate)) continue;
    if (state_cycle_ != seen_.cycle || !state_text_)
      state_text_ = shared(stateText(seen_));  // serialized once for all subscribers
    state_cycle_ = subscriber.cycle = seen_.cycle;
    channel->send(kStateLane, state_text_);
  }
}

void Monitor::publishFaults() {
  if (!faults_pace_.due(now_, kFaultLooks)) return;
  announcer_->update(seen_);
  std::istringstream lines{announced_.str()};
  announced_.str({});
  constexpr std::string_view kPrefix = "darwinop: ";  // for terminals only
  for (std::string line; std::getline(lines, line);)
    notice(line.starts_with(kPrefix) ? line.substr(kPrefix.size()) : line);
  std::string text = faultsText(seen_.safety);
  if (text == faults_text_) return;
  faults_text_ = std::move(text);
  for (const auto& [channel, subscriber] : subscribers_) channel->send(kFaultsLane, shared(faults_text_));
}

void Monitor::publishLoopStats() {
  if (subscribers_.empty() || !loop_pace_.due(now_, 1)) return;
  const runtime::ExchangeBlock& block = *runtime_.block();
  Figures& figures = *figures_;
  figures.before = figures.all;
  block.stats.copyTo(figures.all);
  figures.recent = figures_any_ ? figures.all.since(figures.before) : runtime::StatsView{};
  const double seconds = figures_any_ ? secondsOf(now_ - figures_time_) : 0;
  figures_time_ = now_;
  figures_any_ = true;
  const pid_t driver = runtime_.driver();
  for (const auto& [channel, subscriber] : subscribers_)
    channel->send(kLoopLane, shared(loopText({.all = figures.all,
                                              .recent = figures.recent,
                                              .seconds = seconds,
                                              .driver = driver,
                                              .session = block.session.load(),
                                              .lost = channel->lost()},
                                             seen_)));
}

}  // namespace darwinop::monitor
