// Messages for the user on stderr.
#include "webots/notices.hpp"

#include <cstdio>
#include <mutex>
#include <set>
#include <string>

#include "webots/messages.hpp"

namespace darwinop::webots_api {

namespace {
struct Logged {
  std::mutex mutex;  // controllers may have several threads
  std::set<std::string, std::less<>> sentences;
};

// Never destroyed: a controller's global objects may still log warnings while the program ends.
Logged& logged() {
  static Logged* const instance = new Logged;
  return *instance;
}
}  // namespace

void logLine(std::string_view sentence) {
  const std::string line = "darwinop: " + std::string{sentence} + "\n";
  std::fputs(line.c_str(), stderr);
}

void warnOnce(std::string_view sentence) {
  {
    const std::lock_guard lock{logged().mutex};
    if (!logged().sentences.emplace(sentence).second) return;
  }
  logLine(sentence);
}

void warnNoDevice(std::string_view call, const std::string& name) {
  warnOnce("Robot::" + std::string{call} + "(\"" + name + "\")" + messages::kNoSuchDevice);
}

void forgetWarnings() {
  const std::lock_guard lock{logged().mutex};
  logged().sentences.clear();
}

}  // namespace darwinop::webots_api
