#include "window/transfer.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "window/transfer_command.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

constexpr Nanos kWhileItRuns{20'000'000}, kNothingRuns{1'000'000'000};
constexpr const char* kNoPassword = "a password has at most 200 bytes in one line";
constexpr web::Lane kTransferState = 0, kTransferKnown = 1;
// A controller may take 10 s to end tidily and is killed after 6 s more; see installer/robot/controller_run.sh.
constexpr std::chrono::seconds kLongestFarewell{20};

web::Bytes packed(const json& said) {
  return std::make_shared<const std::string>(said.dump(-1, ' ', false, json::error_handler_t::replace));
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

/// It is read on meanwhile: who cannot get rid of its last words does not end.
Transfer::~Transfer() {
  if (!runs()) return;
  run_->cancel();
  const auto end = std::chrono::steady_clock::now() + kLongestFarewell;
  while (runs() && std::chrono::steady_clock::now() < end)
    if (!run_->look()) std::this_thread::sleep_for(std::chrono::milliseconds{10});
}

void Transfer::opened(web::Channel& channel) {
  pages_[&channel].next = console_.begin();
  channel.send(kTransferKnown, knownText());
  channel.send(kTransferState, stateText());
}

void Transfer::said(web::Channel& channel, std::string_view message, bool binary) {
  const auto found = pages_.find(&channel);
  if (found == pages_.end()) return;
  Page& page = found->second;
  if (binary) {
    page.no_password = !page.password.set(message);
    if (page.no_password) refuse(channel, kNoPassword);
    return;
  }
  std::string why;
  const std::optional<TransferWords> words = readTransfer(message, why);
  if (!words) {
    page.forgetPassword();  // it may have been a start: what was meant for one robot goes to no other
    return refuse(channel, why);
  }
  if (words->start) return start(channel, page, *words->start);
  if (words->cancel && runs()) {
    run_->cancel();
    return tellState();
  }
  if (words->more) {
    page.next = std::min(*words->more, console_.end());
    page.waits = true;
  }
  if (words->forget) {
    remembered_.forget(*words->forget);
    tellKnown();
  }
}

void Transfer::start(web::Channel& channel, Page& page, const TransferStart& start) {
  if (std::exchange(page.no_password, false)) return refuse(channel, kNoPassword);
  if (runs()) {
    page.forgetPassword();
    return refuse(channel, "one thing at a time: wait until what runs has ended, or cancel it");
  }
  try {
    const std::vector<std::string> words = installerWords(start);
    run_.reset();
    console_.add(LineKind::kCommand, typedCommand(words));
    run_ = std::make_unique<TransferRun>(installer_, words, page.password, console_);
  } catch (const std::exception& error) {
    page.forgetPassword();
    return refuse(channel, error.what());
  }
  doing_ = start;
  remembered_.note(start.robot, start.controller);
  tellKnown();
  tellState();
}

void Transfer::turn() {
  if (runs() && run_->look()) tellState();
  for (auto& [channel, page] : pages_) tellLines(*channel, page);
}

Nanos Transfer::pause() const {
  return runs() ? kWhileItRuns : kNothingRuns;
}

void Transfer::tellLines(web::Channel& channel, Page& page) {
  if (!page.waits || page.next >= console_.end() || clock_() - page.told < kLinesPause) return;
  page.next = std::max(page.next, console_.begin());
  json lines = json::array();
  const std::uint64_t first = page.next;
  for (std::size_t bytes = 0; page.next < console_.end() && bytes < kLinesBytes; ++page.next) {
    const ConsoleLine& line = console_.at(page.next);
    lines.push_back({nameOf(line.kind), line.text});
    bytes += line.text.size();
  }
  page.waits = false;  // until it asks for more: a page that is too slow gets less, not late
  page.told = clock_();
  channel.send(web::kEvery, packed({{"type", "lines"}, {"first", first}, {"lines", lines}}));
}

void Transfer::tellState() {
  const web::Bytes text = stateText();
  if (std::exchange(told_, *text) == *text) return;
  for (const auto& [channel, page] : pages_) channel->send(kTransferState, text);
}

void Transfer::tellKnown() {
  const web::Bytes text = knownText();
  for (const auto& [channel, page] : pages_) channel->send(kTransferKnown, text);
}

web::Bytes Transfer::stateText() const {
  json state{{"type", "state"}, {"runs", runs()}, {"action", nullptr}, {"status", nullptr}};
  if (!run_) return packed(state);
  state["action"] = nameOf(doing_.action);
  state["robot"] = jsonOf(doing_.robot);
  state["controller"] = doing_.controller;
  state["cancelled"] = run_->cancelled();
  state["text"] = run_->sentence();
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
                 {"trouble", remembered_.trouble()}});
}

}  // namespace darwinop::window
