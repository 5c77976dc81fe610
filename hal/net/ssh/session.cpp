// Child process darwinop-install --remote: start, wait until ready, forward signals, end.
#include "hal/net/ssh/session.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "hal/signals.hpp"

namespace darwinop::ssh {
namespace {

volatile sig_atomic_t ssh_pid = 0;
volatile sig_atomic_t end_requested = 0;

/// Ctrl-C in a terminal reaches the whole process group, so only signals of other processes (si_code <= 0) are
/// forwarded.
void handOnToSsh(int signal, siginfo_t* info, void*) {
  const int error = errno;
  end_requested = 1;
  if (ssh_pid > 0 && info->si_code <= 0) kill(static_cast<pid_t>(ssh_pid), signal);
  errno = error;
}

void catchSignalsForSsh() {
  onEndSignals(handOnToSsh);
}

std::runtime_error notStarted() {
  return std::runtime_error(std::string{"cannot start darwinop-install: "} + std::strerror(errno));
}

}  // namespace

SshSession::SshSession(std::string program, std::vector<std::string> words) : program_{std::move(program)} {
  start(std::move(words));
}

SshSession::~SshSession() {
  (void)end();
}

void SshSession::start(std::vector<std::string> words) {
  const std::string installer = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "darwinop-install";
  words.insert(words.begin(), {installer, "--remote"});
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int in[2], out[2];
  // O_CLOEXEC: no other child holds the pipe, so it closes when this process dies, even by kill -9.
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) throw notStarted();
  to_ssh_ = in[1];
  from_ssh_ = out[0];
  catchSignalsForSsh();
  pid_ = fork();
  if (pid_ < 0) throw notStarted();
  if (pid_ == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    restoreIgnoredSignals();
    for (const int signal : kEndSignals) std::signal(signal, SIG_DFL);
    execv(installer.c_str(), arguments.data());
    std::cerr << program_ << ": cannot run " << installer << ": " << std::strerror(errno) << std::endl;
    _exit(127);
  }
  ssh_pid = pid_;
  close(in[0]);
  close(out[1]);
  unsetenv("DARWINOP_PASSWORD");  // the robot's password; later children must not inherit it
}

std::vector<std::uint16_t> SshSession::waitUntilReady() {
  std::istringstream line{readLine()};
  std::string word;
  if (!(line >> word) || word != "ready" || isEndRequested()) return {};
  std::vector<std::uint16_t> ports;
  for (std::uint16_t port = 0; line >> port;) ports.push_back(port);
  return ports;
}

/// One line of its stdout; empty at end of file.
std::string SshSession::readLine() const {
  std::string line;
  while (!line.ends_with('\n')) {
    char letter = 0;
    const ssize_t count = read(from_ssh_, &letter, 1);
    if (count == 0 || (count < 0 && errno != EINTR)) return {};
    if (count > 0) line += letter;
  }
  return line;
}

bool SshSession::isEndRequested() {
  return end_requested != 0;
}

bool SshSession::ended() const {
  siginfo_t state{};
  return pid_ > 0 && waitid(P_PID, static_cast<id_t>(pid_), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         state.si_pid == pid_;
}

int SshSession::end() {
  if (pid_ <= 0) return 0;
  catchSignalsForSsh();  // the program may have replaced the handlers in between
  close(to_ssh_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0)
    if (errno != EINTR) break;
  close(from_ssh_);
  pid_ = 0;
  ssh_pid = 0;
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  std::cerr << program_ << ": the program that holds the connection was ended by signal " << WTERMSIG(status)
            << "; the robot's state is unknown. It ends remote control within 10 s and sits down. "
               "In danger press MODE on its back"
            << std::endl;
  return 1;
}

}  // namespace darwinop::ssh
