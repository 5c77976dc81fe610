// `darwinop run --robot tcp://USER@HOST`: remote control on the robot for one run, through ssh.
#include "run_over_ssh.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string_view>

namespace darwinop {
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
  struct sigaction action {};
  action.sa_sigaction = handOnToSsh;
  action.sa_flags = SA_SIGINFO;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

std::runtime_error notStarted() {
  return std::runtime_error(std::string{"cannot start darwinop-install: "} + std::strerror(errno));
}

}  // namespace

std::optional<std::string> sshTarget(const std::string& robot) {
  constexpr std::string_view kTcp = "tcp://";
  if (!robot.starts_with(kTcp) || robot.find('@') == std::string::npos) return std::nullopt;
  std::string target = robot.substr(kTcp.size());
  const std::size_t host = target.rfind('@') + 1;
  if (target.find(':', host) != std::string::npos && target[host] != '[')
    throw std::runtime_error("'" + robot +
                             "' has a port: with a user in front the server gets one by itself; the port of ssh " +
                             "is said with --ssh-port");
  if (target[host] == '[' && target.ends_with(']')) {  // IPv6, which ssh knows without brackets
    target.pop_back();
    target.erase(host, 1);
  }
  return target;
}

RunOverSsh::RunOverSsh(const std::string& installer, const std::vector<std::string>& words) {
  start(installer, words);
}

RunOverSsh::~RunOverSsh() {
  (void)end();
}

void RunOverSsh::start(const std::string& installer, const std::vector<std::string>& words) {
  std::vector<std::string> command{installer, "--remote", "--tell", std::to_string(getpid())};
  command.insert(command.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int in[2], out[2];
  // Not for the controller: when we die, even by kill -9, the pipe ends.
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) throw notStarted();
  say_ = in[1];
  hear_ = out[0];
  catchSignalsForSsh();
  pid_ = fork();
  if (pid_ < 0) throw notStarted();
  if (pid_ == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    execv(installer.c_str(), arguments.data());
    std::cerr << "darwinop run: cannot run " << installer << ": " << std::strerror(errno) << std::endl;
    _exit(127);
  }
  ssh_pid = pid_;
  close(in[0]);
  close(out[1]);
  unsetenv("DARWINOP_PASSWORD");  // the robot's, and no affair of the controller
}

std::optional<std::uint16_t> RunOverSsh::waitUntilReady() {
  constexpr std::string_view kReady = "ready ";
  std::string said;
  while (!said.ends_with('\n')) {
    char letter = 0;
    const ssize_t count = read(hear_, &letter, 1);
    if (count == 0 || (count < 0 && errno != EINTR)) return std::nullopt;
    if (count > 0) said += letter;
  }
  std::uint16_t port = 0;
  if (said.starts_with(kReady)) std::from_chars(said.data() + kReady.size(), said.data() + said.size(), port);
  if (port == 0 || told_to_end != 0) return std::nullopt;
  return port;
}

int RunOverSsh::end() {
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
  std::cerr << "darwinop run: the program that holds the connection was ended by signal " << WTERMSIG(status)
            << ", so how the robot is cannot be told: it ends remote control within 10 s and sits down. "
               "In danger press MODE on its back"
            << std::endl;
  return 1;
}

}  // namespace darwinop
