// ssh connection to a robot for the window.
#include "window/view/ssh_connection.hpp"

#include <utility>

namespace darwinop::window {
namespace {

constexpr Nanos kSendTimeout{300'000'000};  // to send queued messages
constexpr int kPolls = 3;                   // polls within that time; each returns at the first event

std::vector<std::string> forInstaller(std::vector<std::string> words, const std::string& target) {
  words.insert(words.end(), {"--window", target});
  return words;
}

}  // namespace

SshConnection::SshConnection(std::string target, std::vector<std::string> words)
    : target_{std::move(target)}, session_{"darwinop window", forInstaller(std::move(words), target_)} {}

bool SshConnection::waitUntilReady() {
  ports_ = session_.waitUntilReady();
  return ports_.size() == 2;
}

std::string SshConnection::robot() const {
  return "tcp://127.0.0.1:" + std::to_string(ports_.at(0));
}

std::string SshConnection::monitor() const {
  return "127.0.0.1:" + std::to_string(ports_.at(1));
}

void SshConnection::notifyPages(web::WebServer& server, MonitorFeed& feed) const {
  feed.sendEnd("the connection to " + target_ +
               " is over; see the terminal of darwinop window for the reason, then start it again.");
  for (int i = 0; i < kPolls; ++i) server.poll(kSendTimeout / kPolls);
}

}  // namespace darwinop::window
