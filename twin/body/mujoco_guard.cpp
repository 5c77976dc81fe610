#include "twin/body/mujoco_guard.hpp"

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace darwinop::twin {
namespace {

thread_local MujocoGuard* active = nullptr;

// MuJoCo writes a file otherwise; its counters stay, and RobotBody reads them.
void silence(const char* /*warning*/) {}

}  // namespace

void MujocoGuard::giveUp(const char* why) {
  if (active == nullptr) {  // not ours: without a way back there is only the end
    std::fprintf(stderr, "darwinop: MuJoCo gives up: %s\n", why);
    std::_Exit(EXIT_FAILURE);
  }
  std::snprintf(active->why_, sizeof active->why_, "%s", why);
  std::longjmp(active->back_, 1);  // NOLINT(*-err52-cpp): C code is in between, through which nothing may be thrown
}

MujocoGuard::MujocoGuard() noexcept {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = giveUp;
    mju_user_warning = silence;
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
