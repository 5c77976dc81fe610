#include "window/child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace darwinop::window {
namespace {

std::string programOf(const std::string& noun) {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / ("darwinop-" + noun);
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error(program.string() + " is not there; the window needs it, install it, too");
  return program.string();
}

// In the child. What is behind must not get what a terminal sends to the group: it is ended in its turn.
[[noreturn]] void become(char* const* words, pid_t parent, Child::Place place) {
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  if (getppid() != parent) _exit(143);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  if (place == Child::Place::kBehind) {
    setpgid(0, 0);
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
  }
  execv(words[0], words);
  _exit(127);
}

}  // namespace

Child::Child(const std::string& noun, const std::vector<std::string>& arguments, std::chrono::milliseconds grace,
             Place place)
    : noun_{noun}, grace_{grace} {
  std::vector<std::string> words{programOf(noun)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot start darwinop-" + noun + ": " + std::strerror(errno));
  if (pid_ == 0) become(pointers.data(), parent, place);
}

Child::~Child() {
  if (ended()) return;
  kill(pid_, SIGTERM);
  const auto end = std::chrono::steady_clock::now() + grace_;
  while (!ended() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  if (ended()) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

std::optional<int> Child::ended() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_)
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return status_;
}

}  // namespace darwinop::window
