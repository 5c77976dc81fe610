// What the facade tells the user: plain sentences on stderr, each warning once.
#include "webots/notices.hpp"

#include <cstdio>
#include <mutex>
#include <set>
#include <string>

namespace darwinop::facade {

namespace {
struct Said {
  std::mutex mutex;  // controllers may use threads of their own
  std::set<std::string, std::less<>> sentences;
};

// Never destroyed: a controller's global objects may still warn while the program ends.
Said& said() {
  static Said* const instance = new Said;
  return *instance;
}
}  // namespace

void say(std::string_view sentence) {
  const std::string line = "darwinop: " + std::string{sentence} + "\n";
  std::fputs(line.c_str(), stderr);
}

void warnOnce(std::string_view sentence) {
  {
    const std::lock_guard lock{said().mutex};
    if (!said().sentences.emplace(sentence).second) return;
  }
  say(sentence);
}

void forgetWarnings() {
  const std::lock_guard lock{said().mutex};
  said().sentences.clear();
}

}  // namespace darwinop::facade
