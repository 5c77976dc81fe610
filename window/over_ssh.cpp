#include "window/over_ssh.hpp"

#include <utility>

namespace darwinop::window {
namespace {

constexpr Nanos kFarewell{300'000'000};  // for what waits to be sent
constexpr int kLooks = 3;                // within that, each ends with the first thing that happens

std::vector<std::string> forInstaller(std::vector<std::string> words, const std::string& target) {
  words.insert(words.end(), {"--window", target});
  return words;
}

}  // namespace

OverSsh::OverSsh(std::string target, std::vector<std::string> words)
    : target_{std::move(target)}, session_{"darwinop window", forInstaller(std::move(words), target_)} {}

bool OverSsh::arrives() {
  ports_ = session_.waitUntilReady();
  return ports_.size() == 2;
}

std::string OverSsh::robot() const {
  return "tcp://127.0.0.1:" + std::to_string(ports_.at(0));
}

std::string OverSsh::monitor() const {
  return "127.0.0.1:" + std::to_string(ports_.at(1));
}

void OverSsh::tellPages(web::Server& server, Sight& sight) const {
  sight.tellEnd("the connection to " + target_ + " is over; the terminal of darwinop window says why. Start it again.");
  for (int i = 0; i < kLooks; ++i) server.attend(kFarewell / kLooks);
}

}  // namespace darwinop::window
