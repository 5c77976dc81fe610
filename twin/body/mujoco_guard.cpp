// Error handlers of MuJoCo: jump back to the active guard.
#include "twin/body/mujoco_guard.hpp"

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace darwinop::twin {
namespace {

thread_local MujocoGuard* active = nullptr;

// MuJoCo's default handler writes a log file. The warning counters are still updated; RobotBody reads them.
void ignoreWarning(const char* /*warning*/) {}

}  // namespace

void MujocoGuard::onError(const char* why) {
  if (active == nullptr) {  // outside of attempt(): the handler must not return
    std::fprintf(stderr, "darwinop: MuJoCo error: %s\n", why);
    std::_Exit(EXIT_FAILURE);
  }
  std::snprintf(active->why_, sizeof active->why_, "%s", why);
  std::longjmp(active->back_, 1);  // NOLINT(*-err52-cpp): exceptions must not pass through C frames
}

MujocoGuard::MujocoGuard() noexcept {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = onError;
    mju_user_warning = ignoreWarning;
  });
  active = this;
}

MujocoGuard::~MujocoGuard() {
  active = nullptr;
}

std::string oneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank || (!line.empty() && line.back() != ' ')) line += blank ? ' ' : c;
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace darwinop::twin
