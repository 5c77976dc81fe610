// fork and exec of a child process, its signals and its end.
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
#include <string_view>
#include <thread>

#include "hal/signals.hpp"

namespace darwinop::window {
namespace {

using Streams = std::array<int, Child::kStreams>;

constexpr int kAboveStreams = 10;

std::runtime_error notStarted(const std::string& noun) {
  return std::runtime_error("cannot start darwinop-" + noun + ": " + std::strerror(errno));
}

/// Pipe ends: ours (non-blocking) and the child's.
struct Pipes {
  Streams ours{-1, -1, -1}, theirs{-1, -1, -1};

  explicit Pipes(bool wanted, const std::string& noun) {
    for (std::size_t i = 0; wanted && i < Child::kStreams; ++i) {
      int ends[2];
      if (pipe2(ends, O_CLOEXEC) != 0) {
        const int error = errno;
        close(ours);
        close(theirs);
        errno = error;
        throw notStarted(noun);
      }
      ours[i] = ends[0];
      theirs[i] = ends[1];
      fcntl(ours[i], F_SETFL, O_NONBLOCK);
    }
  }
  static void close(const Streams& streams) {
    for (const int stream : streams)
      if (stream >= 0) ::close(stream);
  }
};

/// Our environment without the password of our own login, plus `variable`.
std::vector<char*> environmentWith(char* variable) {
  std::vector<char*> all;
  for (char** word = environ; *word != nullptr; ++word)
    if (!std::string_view{*word}.starts_with("DARWINOP_PASSWORD=")) all.push_back(*word);
  if (variable != nullptr) all.push_back(variable);
  all.push_back(nullptr);
  return all;
}

/// In the child: moves the pipes to descriptors 1 to 3 and closes all others, such as connections of browsers.
void moveStreams(const Streams& theirs) {
  Streams high{};
  for (std::size_t i = 0; i < high.size(); ++i) high[i] = fcntl(theirs[i], F_DUPFD, kAboveStreams);
  for (std::size_t i = 0; i < high.size(); ++i) dup2(high[i], static_cast<int>(i) + STDOUT_FILENO);
  close_range(Child::kStreams + 1, ~0U, 0);
}

// In the child. A background child has its own process group, so that Ctrl-C in the terminal does not reach it: it is
// ended in order. A captured child has its own session, so that ssh cannot ask questions on the terminal.
[[noreturn]] void execute(char* const* words, char* const* environment, pid_t parent, Child::Stdio stdio,
                          const Streams& theirs) {
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  if (getppid() != parent) _exit(143);
  restoreIgnoredSignals();
  if (stdio != Child::Stdio::kTerminal) {
    stdio == Child::Stdio::kCaptured ? setsid() : setpgid(0, 0);
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    dup2(nowhere, STDIN_FILENO);
    if (stdio == Child::Stdio::kBackground) dup2(nowhere, STDOUT_FILENO);
  }
  if (stdio == Child::Stdio::kCaptured) {
    for (const int signal : kEndSignals) std::signal(signal, SIG_DFL);
    moveStreams(theirs);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execve(words[0], words, environment);
  _exit(127);
}

}  // namespace

std::string Child::programOf(const std::string& noun) {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / ("darwinop-" + noun);
}

Child::Child(std::string noun, const std::string& program, const std::vector<std::string>& arguments,
             std::chrono::milliseconds grace, Stdio stdio, char* variable)
    : noun_{std::move(noun)}, grace_{grace}, stdio_{stdio} {
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error("cannot run " + program + ": " + std::strerror(errno) +
                             "; the window requires it, install it as well");
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const std::vector<char*> environment = environmentWith(variable);
  const Pipes pipes{stdio == Stdio::kCaptured, noun_};
  const pid_t parent = getpid();
  // Blocks signals between fork and exec: until then the child has our handlers, which would swallow them.
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  pid_ = fork();
  if (pid_ == 0) execute(pointers.data(), environment.data(), parent, stdio, pipes.theirs);
  const int error = errno;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  Pipes::close(pipes.theirs);
  streams_ = pipes.ours;
  if (pid_ > 0) return;
  Pipes::close(streams_);
  errno = error;
  throw notStarted(noun_);
}

Child::~Child() {
  sendSignal(stdio_ == Stdio::kCaptured ? SIGINT : SIGTERM);
  if (!endsWithin(grace_)) {
    kill(pid_, SIGKILL);  // not its group: processes that are still cleaning up end by themselves
    waitpid(pid_, nullptr, 0);
  }
  Pipes::close(streams_);
}

void Child::interrupt() {
  if (!ended()) sendSignal(SIGINT);
}

/// Falls back to the process: just after the start it may not lead a group yet.
void Child::sendSignal(int signal) const {
  if (status_) return;
  if (stdio_ != Stdio::kCaptured || kill(-pid_, signal) != 0) kill(pid_, signal);
}

bool Child::endsWithin(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!ended() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  return ended().has_value();
}

std::optional<int> Child::ended() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_)
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return status_;
}

}  // namespace darwinop::window
