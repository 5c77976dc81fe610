// Transfer channel: requests, state, console lines.
#include "window/transfer/transfer.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "core/json/json_text.hpp"
#include "window/messages.hpp"
#include "window/transfer/transfer_command.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

constexpr Nanos kWhileItRuns{20'000'000}, kNothingRuns{1'000'000'000};
constexpr web::Lane kTransferState = 0, kTransferKnown = 1;
// A controller gets 10 s to end and is killed after 6 s more; see installer/robot/controller_run.sh.
constexpr std::chrono::seconds kCancelTimeout{20};

web::Bytes packed(const json& message) {
  return std::make_shared<const std::string>(jsonText(message));
}

void refuse(web::Channel& channel, const std::string& why) {
  channel.send(web::kEvery, packed({{"type", "refused"}, {"text", why}}));
}

}  // namespace

Transfer::Transfer(std::string installer, std::filesystem::path remembered, Clock clock,
                   std::optional<RobotAddress> given)
    : installer_{std::move(installer)},
      clock_{std::move(clock)},
      given_{std::move(given)},
      remembered_{std::move(remembered)} {}

/// Keeps reading its output, because a process with a full pipe does not end.
Transfer::~Transfer() {
  cancel();
  const auto end = std::chrono::steady_clock::now() + kCancelTimeout;
  while (runs() && std::chrono::steady_clock::now() < end)
    if (!poll()) std::this_thread::sleep_for(std::chrono::milliseconds{10});
}

void Transfer::opened(web::Channel& channel) {
  pages_[&channel].next = console_.begin();
  channel.send(kTransferKnown, knownText());
  channel.send(kTransferState, stateText());
}

void Transfer::received(web::Channel& channel, std::string_view message, bool binary) {
  const auto found = pages_.find(&channel);
  if (found == pages_.end()) return;
  PageConnection& page = found->second;
  if (binary) {
    page.password_rejected = !page.password.set(message);
    if (page.password_rejected) refuse(channel, messages::kInvalidPassword);
    return;
  }
  std::string why;
  const std::optional<TransferMessage> request = parseTransfer(message, why);
  if (!request) {
    page.forgetPassword();  // it may have been a start: the password must not be used for another robot
    return refuse(channel, why);
  }
  if (request->start) return start(channel, page, *request->start);
  if (request->cancel && runs()) {
    cancel();
    return sendState();
  }
  if (request->more) {
    page.next = std::min(*request->more, console_.end());
    page.wants_lines = true;
  }
  if (request->forget) {
    remembered_.forget(*request->forget);
    sendKnown();
  }
}

void Transfer::start(web::Channel& channel, PageConnection& page, const TransferStart& start) {
  if (std::exchange(page.password_rejected, false)) return refuse(channel, messages::kInvalidPassword);
  if (runs()) {
    page.forgetPassword();
    return refuse(channel, messages::kAnotherTransferRuns);
  }
  try {
    const std::vector<std::string> arguments = installerArguments(start);
    run_.reset();
    state_ = next(state_, TransferEvent::kNotStarted);
    console_.add(LineKind::kCommand, typedCommand(arguments));
    run_ = std::make_unique<TransferRun>(installer_, arguments, page.password, console_);
    state_ = next(state_, TransferEvent::kStarted);
  } catch (const std::exception& error) {
    page.forgetPassword();
    return refuse(channel, error.what());
  }
  request_ = start;
  remembered_.note(start.robot, start.controller);
  sendKnown();
  sendState();
}

/// True: something is new.
bool Transfer::poll() {
  if (!runs() || !run_->poll()) return false;
  if (run_->status()) state_ = next(state_, TransferEvent::kExited);
  return true;
}

void Transfer::cancel() {
  const TransferState after = next(state_, TransferEvent::kCancelAsked);
  if (std::exchange(state_, after) != after) run_->interrupt();
}

void Transfer::update() {
  if (poll()) sendState();
  for (auto& [channel, page] : pages_) sendLines(*channel, page);
}

Nanos Transfer::pause() const {
  return runs() ? kWhileItRuns : kNothingRuns;
}

void Transfer::sendLines(web::Channel& channel, PageConnection& page) {
  if (!page.wants_lines || page.next >= console_.end() || clock_() - page.sent_at < kLinesPause) return;
  page.next = std::max(page.next, console_.begin());
  json lines = json::array();
  const std::uint64_t first = page.next;
  for (std::size_t bytes = 0; page.next < console_.end() && bytes < kLinesBytes; ++page.next) {
    const ConsoleLine& line = console_.at(page.next);
    lines.push_back({nameOf(line.kind), line.text});
    bytes += line.text.size();
  }
  page.wants_lines = false;  // until it requests more: flow control for slow pages
  page.sent_at = clock_();
  channel.send(web::kEvery, packed({{"type", "lines"}, {"first", first}, {"lines", lines}}));
}

void Transfer::sendState() {
  const web::Bytes text = stateText();
  if (std::exchange(sent_state_, *text) == *text) return;
  for (const auto& [channel, page] : pages_) channel->send(kTransferState, text);
}

void Transfer::sendKnown() {
  const web::Bytes text = knownText();
  for (const auto& [channel, page] : pages_) channel->send(kTransferKnown, text);
}

web::Bytes Transfer::stateText() const {
  json state{{"type", "state"}, {"runs", runs()}, {"action", nullptr}, {"status", nullptr}};
  if (!run_) return packed(state);
  state["action"] = nameOf(request_.action);
  state["robot"] = jsonOf(request_.robot);
  state["controller"] = request_.controller;
  state["cancelled"] = isCancelled(state_);
  state["text"] = run_->summary();
  state["host_key"] = run_->hostKey();
  state["step"] = nullptr;
  if (const auto& step = run_->step())
    state["step"] = {{"number", step->number},
                     {"of", step->of},
                     {"part", step->part ? json(*step->part) : json(nullptr)},
                     {"name", step->name}};
  if (const std::optional<int> status = run_->status()) state["status"] = *status;
  return packed(state);
}

web::Bytes Transfer::knownText() const {
  json robots = json::array();
  for (const RobotAddress& robot : remembered_.all().robots) robots.push_back(jsonOf(robot));
  return packed({{"type", "known"},
                 {"robots", robots},
                 {"given", given_ ? jsonOf(*given_) : json(nullptr)},
                 {"controllers", remembered_.all().controllers},
                 {"examples", controllersBeside(installer_)},
                 {"trouble", remembered_.error()}});  // keep-word: name in the protocol
}

}  // namespace darwinop::window
