// Steering channel of two pages: one driver at most, bounded commands.
// One input line is one event.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "window/driver.hpp"

namespace {

using namespace darwinop;

void expect(bool holds) {
  if (!holds) std::abort();
}

struct HelmOfFuzz final : window::Helm {
  void begin() override {
    expect(now.state == State::kFree);
    now = {.state = State::kAsking};
  }
  void order(const window::Orders& orders) override {
    expect(now.state == State::kDriving && orders.page >= 0 && orders.page <= 255);
    for (const auto& goal : orders.goals) expect(!goal || std::isfinite(goal->value));
    if (!orders.walk) return;
    for (const double part : {orders.walk->x, orders.walk->y, orders.walk->a}) expect(std::abs(part) <= 1);
  }
  void stop() override { letGo(); }
  void leave() override { letGo(); }
  Report report() override { return now; }
  void letGo() {
    expect(now.state != State::kFree);
    now = {.state = State::kEnding};
  }

  Report now{};
};

struct PageOfFuzz final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane /*lane*/, web::Bytes text) override {
    expect(text->front() == '{' && text->back() == '}' && text->find('\n') == std::string::npos);
    if (text->find(R"("type":"driving")") != std::string::npos)
      yours = text->find(R"("yours":true)") != std::string::npos;
  }
  void sendBinary(web::Lane /*lane*/, web::Bytes /*bytes*/) override { std::abort(); }
  void forgetNewest() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string& /*why*/) override {}

  std::string who = "page";
  bool yours = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Nanos now{0};
  HelmOfFuzz helm;
  PageOfFuzz pages[2];
  window::Driver driver{helm, [&] { return now; }};
  for (PageOfFuzz& page : pages) driver.opened(page);
  std::string_view rest{reinterpret_cast<const char*>(data), size};
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.empty()) continue;
    PageOfFuzz& page = pages[line[0] & 1];
    switch (line[0]) {
      case 'g':
        helm.now = {.state = window::Helm::State::kDriving};
        break;  // it has the robot, or falls from the sky
      case 'e':
        helm.now = {.why = "it ended"};
        break;
      case 'p':
        now += Nanos{300'000'000};
        break;
      case 'c':
      case 'd':
        driver.closed(page);
        page.yours = false;
        break;
      case 'B':
        driver.said(page, line.substr(1), true);
        break;
      default:
        driver.said(page, line.substr(1), false);
    }
    driver.turn();
    expect(!(pages[0].yours && pages[1].yours));
    expect(driver.drives() || (!pages[0].yours && !pages[1].yours));
  }
  return 0;
}
