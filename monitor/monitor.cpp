#include "monitor/monitor.hpp"

#include <algorithm>
#include <utility>

#include "monitor/messages.hpp"
#include "monitor/picture.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::monitor {
namespace {

/// One lane for each kind of message of which only the newest counts.
enum MonitorLane : web::Lane {
  kHelloLane,
  kGoneLane,
  kStateLane,
  kLoopLane,
  kFaultsLane,
  kCameraLane,
  kPictureLane,
  kErrorLane,
  kFoundLane
};
static_assert(kFoundLane < web::kLanes);

constexpr double kFaultLooks = 10, kDriverLooks = 20;  // Hz
constexpr Nanos kShortest{4'000'000}, kLongest{50'000'000}, kIdle{100'000'000};

web::Bytes shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

double secondsOf(Nanos time) {
  return std::chrono::duration<double>{time}.count();
}

}  // namespace

Monitor::Monitor(const runtime::RuntimeFiles& files, Clock clock, Eye::Open open_camera, Eye::Open share_camera,
                 std::shared_ptr<ColourSearch> search)
    : onlooker_{files},
      clock_{std::move(clock)},
      eye_{std::move(open_camera), std::move(share_camera)},
      search_{std::move(search)} {
  now_ = clock_();
  (void)onlooker_.look(now_);
  turn();
}

void Monitor::opened(web::Channel& channel) {
  const Seat& seat = seats_[&channel];
  channel.send(kHelloLane,
               shared(helloText(onlooker_.block() != nullptr ? &onlooker_.block()->info : nullptr, seat.wishes)));
  tellWhatIs(channel);
  for (const web::Bytes& notice : notices_) channel.send(web::kEvery, notice);
}

void Monitor::tellWhatIs(web::Channel& channel) {
  if (onlooker_.block() == nullptr)
    channel.send(kGoneLane, shared(goneText(onlooker_.reason())));
  else
    channel.send(kFaultsLane, shared(faults_text_));
}

void Monitor::said(web::Channel& channel, std::string_view message, bool binary) {
  const auto seat = seats_.find(&channel);
  if (seat == seats_.end()) return;
  std::string why = "say what you want as text";
  const std::optional<Wishes> wishes = binary ? std::nullopt : readWishes(message, seat->second.wishes, why);
  if (!wishes) return channel.send(kErrorLane, shared(errorText(why)));
  searches_changed_ |= wishes->find != seat->second.wishes.find || wishes->camera != seat->second.wishes.camera;
  seat->second.wishes = *wishes;
  seat->second.state.restart();
  seat->second.pictures.restart();
  if (wishes->camera == 0) seat->second.camera.clear();
}

void Monitor::notice(const std::string& text) {
  const double time =
      onlooker_.block() != nullptr && seen_.cycle > 0 ? static_cast<double>(seen_.time_ns) * 1e-9 : kUnknown;
  notices_.push_back(shared(noticeText(++notice_number_, time, text)));
  if (notices_.size() > kNotices) notices_.pop_front();
  for (const auto& [channel, seat] : seats_) channel->send(web::kEvery, notices_.back());
}

Nanos Monitor::pause() const {
  if (seats_.empty()) return kIdle;
  double most = 0;
  for (const auto& [channel, seat] : seats_) most = std::max({most, seat.wishes.rate, seat.wishes.camera});
  if (most <= 0) return kLongest;
  return std::clamp(periodOf(most) / 2, kShortest, kLongest);
}

void Monitor::look() {
  now_ = clock_();
  if (onlooker_.look(now_)) {
    turn();
    const runtime::ExchangeBlock* const block = onlooker_.block();
    notice(block == nullptr ? onlooker_.reason() : "there is a runtime, pid " + std::to_string(block->info.pid));
  }
  if (onlooker_.block() != nullptr) {
    (void)onlooker_.block()->sensors.read(seen_);  // keeps what it held when the loop was quicker
    lookAtState();
    lookAtFaults();
    lookAtLoop();
  }
  lookAtCamera();
}

/// A runtime has come or gone, or is gone for another reason.
void Monitor::turn() {
  seen_ = {};
  state_text_.reset();
  state_cycle_ = 0;
  figures_any_ = false;
  announced_.str({});
  announcer_ = std::make_unique<runtime::FaultAnnouncer>(announced_);
  faults_text_ = faultsText({});
  driver_ = 0;
  const runtime::ExchangeBlock* const block = onlooker_.block();
  for (auto& [channel, seat] : seats_) {
    channel->forgetNewest();  // all of it was said of another runtime
    if (block != nullptr) channel->send(kHelloLane, shared(helloText(&block->info, seat.wishes)));
    tellWhatIs(*channel);
    seat.cycle = 0;
    seat.camera.clear();
    seat.state.restart();
  }
}

bool Monitor::everyCycle(const Seat& seat) const {
  constexpr double kNearly = 0.99;  // 62.5 Hz of 16 ms: a clock of our own would now and then miss one
  return seat.wishes.rate > 0 && seat.wishes.rate * static_cast<double>(seen_.period_ns) * 1e-9 >= kNearly;
}

void Monitor::lookAtState() {
  if (seen_.cycle == 0) return;
  for (auto& [channel, seat] : seats_) {
    if (seat.cycle == seen_.cycle) continue;
    if (!everyCycle(seat) && !seat.state.due(now_, seat.wishes.rate)) continue;
    if (state_cycle_ != seen_.cycle || !state_text_) state_text_ = shared(stateText(seen_));  // one for all
    state_cycle_ = seat.cycle = seen_.cycle;
    channel->send(kStateLane, state_text_);
  }
}

void Monitor::lookAtFaults() {
  if (!faults_pace_.due(now_, kFaultLooks)) return;
  announcer_->look(seen_);
  std::istringstream lines{announced_.str()};
  announced_.str({});
  constexpr std::string_view kPrefix = "darwinop: ";  // that is what a terminal needs
  for (std::string line; std::getline(lines, line);)
    notice(line.starts_with(kPrefix) ? line.substr(kPrefix.size()) : line);
  std::string text = faultsText(seen_.safety);
  if (text == faults_text_) return;
  faults_text_ = std::move(text);
  for (const auto& [channel, seat] : seats_) channel->send(kFaultsLane, shared(faults_text_));
}

void Monitor::lookAtLoop() {
  if (seats_.empty() || !loop_pace_.due(now_, 1)) return;
  const runtime::ExchangeBlock& block = *onlooker_.block();
  Figures& figures = *figures_;
  figures.before = figures.all;
  block.stats.copyTo(figures.all);
  figures.recent = figures_any_ ? figures.all.since(figures.before) : runtime::StatsView{};
  const double seconds = figures_any_ ? secondsOf(now_ - figures_time_) : 0;
  figures_time_ = now_;
  figures_any_ = true;
  const pid_t driver = onlooker_.driver();
  for (const auto& [channel, seat] : seats_)
    channel->send(kLoopLane, shared(loopText({.all = figures.all,
                                              .recent = figures.recent,
                                              .seconds = seconds,
                                              .driver = driver,
                                              .session = block.session.load(),
                                              .lost = channel->lost()},
                                             seen_)));
}

void Monitor::lookAtCamera() {
  if (std::exchange(searches_changed_, false)) updateSearches();
  const auto wants = [](const auto& seat) { return seat.second.wishes.camera > 0; };
  const bool wanted = std::ranges::any_of(seats_, wants);
  const bool runs = onlooker_.block() != nullptr;
  if (wanted && runs && driver_pace_.due(now_, kDriverLooks)) driver_ = onlooker_.driver();
  eye_.look(wanted && runs, driver_ == 0 || driver_ == own_driver_, now_);
  if (!wanted) return;
  const remote::JpegPicture picture = eye_.newest();
  web::Bytes message;
  for (auto& [channel, seat] : seats_) {
    if (seat.wishes.camera <= 0) continue;
    tellOfCamera(*channel, seat, picture.sequence != 0);
    if (picture.sequence == 0 || picture.sequence == seat.picture) continue;
    if (!seat.pictures.due(now_, seat.wishes.camera)) continue;
    if (!message) message = shared(pictureMessage(picture, remote::kWholeImage));
    seat.picture = picture.sequence;
    // What was found in it goes ahead of it, so that both can be shown at once.
    if (search_ && seat.wishes.find)
      if (const std::optional<Found> found = search_->found(*seat.wishes.find, picture.sequence))
        channel->send(kFoundLane, shared(foundText(*found, seat.wishes.mask)));
    channel->sendBinary(kPictureLane, message);
  }
}

void Monitor::updateSearches() {
  if (!search_) return;
  std::vector<Search> searches;
  for (const auto& [channel, seat] : seats_)
    if (seat.wishes.camera > 0 && seat.wishes.find) searches.push_back(*seat.wishes.find);
  search_->want(searches);
}

void Monitor::tellOfCamera(web::Channel& channel, Seat& seat, bool seeing) {
  std::string text;
  if (onlooker_.block() == nullptr)
    text = cameraText(false, "there is no runtime");
  else if (const std::string why = eye_.why(); !why.empty())
    text = cameraText(false, why);
  else
    text = cameraText(seeing, seeing          ? ""
                              : eye_.shared() ? "a controller drives, and shows no pictures of 320x240"
                                              : "the camera gives no pictures");
  if (text == seat.camera) return;
  seat.camera = text;
  channel.send(kCameraLane, shared(std::move(text)));
}

}  // namespace darwinop::monitor
