// Starts and ends `darwinop run` as a child process.
#include "twin/view/controller_process.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "hal/signals.hpp"

namespace darwinop::twin {
namespace {

constexpr std::chrono::milliseconds kGrace{2000};

/// darwinop-run in the folder of this program.
std::string runner() {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "darwinop-run";
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error("cannot start the controller: " + program.string() + " is not installed");
  return program.string();
}

}  // namespace

ControllerProcess::ControllerProcess(const std::vector<std::string>& controller, const std::string& port) {
  const std::string program = runner();
  std::vector<std::string> words{program, "--robot", port, "--"};
  words.insert(words.end(), controller.begin(), controller.end());
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(std::string{"cannot start the controller: "} + std::strerror(errno));
  if (pid_ > 0) return;
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  if (getppid() != parent) _exit(143);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  restoreIgnoredSignals();
  execv(program.c_str(), arguments.data());
  _exit(127);
}

ControllerProcess::~ControllerProcess() {
  signal(SIGTERM);
  const auto end = std::chrono::steady_clock::now() + kGrace;
  while (!ended() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  if (ended()) return;
  signal(SIGKILL);
  waitpid(pid_, nullptr, 0);
}

std::optional<int> ControllerProcess::ended() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_)
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return status_;
}

void ControllerProcess::signal(int number) const {
  if (!status_) kill(pid_, number);
}

}  // namespace darwinop::twin
