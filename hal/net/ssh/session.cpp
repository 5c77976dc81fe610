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
volatile sig_atomic_t told_to_end = 0;

/// Ctrl-C in a terminal reaches the program over there by itself; what another process sends reaches only us.
void handOnToSsh(int signal, siginfo_t* info, void*) {
  const int error = errno;
  told_to_end = 1;
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
  // For no other child: when we die, even by kill -9, the pipe ends.
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) throw notStarted();
  say_ = in[1];
  hear_ = out[0];
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
  unsetenv("DARWINOP_PASSWORD");  // the robot's, and no affair of whoever is started later
}

std::vector<std::uint16_t> SshSession::waitUntilReady() {
  std::istringstream said{hear()};
  std::string word;
  if (!(said >> word) || word != "ready" || toldToEnd()) return {};
  std::vector<std::uint16_t> ports;
  for (std::uint16_t port = 0; said >> port;) ports.push_back(port);
  return ports;
}

/// A line; empty: it says no more.
std::string SshSession::hear() const {
  std::string said;
  while (!said.ends_with('\n')) {
    char letter = 0;
    const ssize_t count = read(hear_, &letter, 1);
    if (count == 0 || (count < 0 && errno != EINTR)) return {};
    if (count > 0) said += letter;
  }
  return said;
}

bool SshSession::toldToEnd() {
  return told_to_end != 0;
}

bool SshSession::ended() const {
  siginfo_t state{};
  return pid_ > 0 && waitid(P_PID, static_cast<id_t>(pid_), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         state.si_pid == pid_;
}

int SshSession::end() {
  if (pid_ <= 0) return 0;
  catchSignalsForSsh();  // whoever ran meanwhile had them
  close(say_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0)
    if (errno != EINTR) break;
  close(hear_);
  pid_ = 0;
  ssh_pid = 0;
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  std::cerr << program_ << ": the program that holds the connection was ended by signal " << WTERMSIG(status)
            << ", so how the robot is cannot be told: it ends remote control within 10 s and sits down. "
               "In danger press MODE on its back"
            << std::endl;
  return 1;
}

}  // namespace darwinop::ssh
