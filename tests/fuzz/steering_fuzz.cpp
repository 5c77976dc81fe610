// Steering channel of two pages: one driver at most, bounded commands.
// One input line is one event.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "window/drive/steering_session.hpp"

namespace {

using namespace darwinop;

void expect(bool holds) {
  if (!holds) std::abort();
}

struct FakeDrive final : window::DriveInterface {
  void start() override {
    expect(now.state == window::DriveState::kFree);
    now = {.state = window::DriveState::kStarting};
  }
  void request(const window::DriveRequests& requests) override {
    expect(now.state == window::DriveState::kDriving && requests.page >= 0 && requests.page <= 255);
    for (const auto& goal : requests.goals) expect(!goal || std::isfinite(goal->value));
    if (!requests.walk) return;
    for (const double part : {requests.walk->x, requests.walk->y, requests.walk->a}) expect(std::abs(part) <= 1);
  }
  void stop() override { endSession(); }
  void finish() override { endSession(); }
  Report report() override { return now; }
  void endSession() {
    expect(now.state != window::DriveState::kFree);
    now = {.state = window::DriveState::kEnding};
  }

  Report now{};
};

struct FakePage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane /*lane*/, web::Bytes text) override {
    expect(text->front() == '{' && text->back() == '}' && text->find('\n') == std::string::npos);
    if (text->find(R"("type":"driving")") != std::string::npos)
      yours = text->find(R"("yours":true)") != std::string::npos;
  }
  void sendBinary(web::Lane /*lane*/, web::Bytes /*bytes*/) override { std::abort(); }
  void discardQueued() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string& /*why*/) override {}

  std::string who = "page";
  bool yours = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Nanos now{0};
  FakeDrive drive;
  FakePage pages[2];
  window::SteeringSession session{drive, [&] { return now; }};
  for (FakePage& page : pages) session.opened(page);
  std::string_view rest{reinterpret_cast<const char*>(data), size};
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.empty()) continue;
    FakePage& page = pages[line[0] & 1];
    switch (line[0]) {
      case 'g':
        drive.now = {.state = window::DriveState::kDriving};
        break;  // it has the robot, or falls from the sky
      case 'e':
        drive.now = {.why = "it ended"};
        break;
      case 'p':
        now += Nanos{300'000'000};
        break;
      case 'c':
      case 'd':
        session.closed(page);
        page.yours = false;
        break;
      case 'B':
        session.received(page, line.substr(1), true);
        break;
      default:
        session.received(page, line.substr(1), false);
    }
    session.update();
    expect(!(pages[0].yours && pages[1].yours));
    expect(session.drives() || (!pages[0].yours && !pages[1].yours));
  }
  return 0;
}
