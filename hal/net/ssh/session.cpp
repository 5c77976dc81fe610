// Child process darwinop-install --remote: start, wait until ready, forward signals, end.
#include "hal/net/ssh/session.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <sstream>
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

}  // namespace

SshSession::SshSession(std::string program, std::vector<std::string> words) : program_{std::move(program)} {
  start(std::move(words));
}

SshSession::~SshSession() {
  (void)end();
}

void SshSession::start(std::vector<std::string> words) {
  using process::Stream;
  words.insert(words.begin(), {process::programBeside("darwinop-install"), "--remote"});
  catchSignalsForSsh();
  {
    const process::SignalsHeld until_the_pid_is_known;
    process_.emplace(process::Start{
        .command = std::move(words), .streams = {Stream::pipe(), Stream::pipe()}, .error_prefix = program_ + ": "});
    ssh_pid = process_->pid();
  }
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
    const ssize_t count = read(process_->stream(STDOUT_FILENO), &letter, 1);
    if (count == 0 || (count < 0 && errno != EINTR)) return {};
    if (count > 0) line += letter;
  }
  return line;
}

bool SshSession::isEndRequested() {
  return end_requested != 0;
}

bool SshSession::ended() {
  return process_ && process_->ended().has_value();
}

int SshSession::end() {
  if (!process_) return 0;
  catchSignalsForSsh();                 // the program may have replaced the handlers in between
  process_->closeStream(STDIN_FILENO);  // it ends the programs on the robot
  const process::Ending ending = process_->wait();
  ssh_pid = 0;
  process_.reset();
  if (!ending.by_signal) return ending.code;
  std::cerr << program_ << ": the program that holds the connection was ended by signal " << ending.code
            << "; the robot's state is unknown. It ends remote control within 10 s and sits down. "
               "In danger press MODE on its back"
            << std::endl;
  return 1;
}

}  // namespace darwinop::ssh
