#include "hal/process/child_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <thread>

#include "hal/process/exec.hpp"

namespace darwinop::process {
namespace {

std::vector<std::string> environmentOf(const Start& start) {
  std::vector<std::string> all = start.environment;
  if (start.account)
    for (const auto& [name, value] : environmentOf(*start.account)) all.push_back(name + "=" + value);
  const auto given = all.size();
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text{*variable}, name = text.substr(0, text.find('='));
    const auto replaces = [&](std::string_view one) { return one.substr(0, one.find('=')) == name; };
    if (name != start.without_variable && std::none_of(all.begin(), all.begin() + static_cast<long>(given), replaces))
      all.emplace_back(text);
  }
  return all;
}

std::vector<char*> pointersTo(const std::vector<std::string>& words) {
  std::vector<char*> list;
  list.reserve(words.size() + 2);
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  return list;
}

Prepared prepare(const Start& start) {
  Prepared with{start,   findProgram(start.command.at(0)), environmentOf(start), pointersTo(start.command), {}, {}, -1,
                getpid()};
  with.variables = pointersTo(with.environment);
  if (start.secret != nullptr) with.variables.push_back(start.secret);
  if (!start.name.empty()) with.arguments.front() = const_cast<char*>(start.name.c_str());
  with.arguments.push_back(nullptr);
  with.variables.push_back(nullptr);
  with.descriptors.fill(-1);
  return with;
}

/// All of them have O_CLOEXEC, so that no other child holds an end open.
struct Pipe {
  int read = -1, write = -1;

  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error{errno, std::generic_category(), "cannot create a pipe"};
    read = ends[0];
    write = ends[1];
  }
  ~Pipe() {
    for (const int end : {read, write})
      if (end >= 0) close(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
};

[[gnu::noinline]] pid_t startBeside(Prepared& with) {
  const pid_t pid = vfork();
  if (pid == 0) execute(with);
  return pid;
}

pid_t startForked(Prepared& with) {
  const pid_t pid = fork();
  if (pid == 0) execute(with);
  return pid;
}

}  // namespace

SignalsHeld::SignalsHeld() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before_);
}

SignalsHeld::~SignalsHeld() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

ChildProcess::ChildProcess(const Start& start) {
  Prepared with = prepare(start);
  std::array<std::optional<Pipe>, Start::kMaxStreams> pipes;
  for (std::size_t i = 0; i < start.streams.size(); ++i) {
    if (start.streams[i].kind == Stream::Kind::kPipe) {
      pipes.at(i).emplace();
      with.descriptors[i] = i == 0 ? pipes[i]->read : pipes[i]->write;
    } else {
      with.descriptors.at(i) = start.streams[i].descriptor;
    }
  }
  std::optional<Pipe> failure;
  if (!start.error_prefix) with.failure = failure.emplace().write;
  int error = 0;
  {
    const SignalsHeld held;  // none of our handlers may run in the child
    pid_ = start.error_prefix ? startForked(with) : startBeside(with);
    error = pid_ < 0 ? errno : 0;
  }
  if (failure && pid_ > 0) {
    close(failure->write);
    failure->write = -1;
    ssize_t count = 0;
    while ((count = read(failure->read, &error, sizeof error)) < 0 && errno == EINTR) continue;
    if (count > 0) (void)wait();
  }
  if (error != 0) throw std::system_error{error, std::generic_category(), kCannotStart + start.command.front()};
  for (std::size_t i = 0; i < pipes.size(); ++i)
    if (pipes[i]) streams_[i] = std::exchange(i == 0 ? pipes[i]->write : pipes[i]->read, -1);
}

ChildProcess::~ChildProcess() {
  for (std::size_t i = 0; i < streams_.size(); ++i) closeStream(i);
  signal(SIGTERM);
  (void)ended();  // one that has not ended yet is reaped by init once we have ended
}

void ChildProcess::closeStream(std::size_t number) {
  int& stream = streams_.at(number);
  if (stream >= 0) close(stream);
  stream = -1;
}

bool ChildProcess::reap(int options) {
  if (ending_) return true;
  int status = 0;
  pid_t reaped = 0;
  while ((reaped = waitpid(pid_, &status, options)) < 0 && errno == EINTR) continue;
  if (reaped < 0) ending_ = Ending{SIGKILL, true};
  if (reaped == pid_)
    ending_ = WIFSIGNALED(status) ? Ending{WTERMSIG(status), true} : Ending{WEXITSTATUS(status), false};
  return ending_.has_value();
}

std::optional<Ending> ChildProcess::ended() {
  (void)reap(WNOHANG);
  return ending_;
}

Ending ChildProcess::wait() {
  (void)reap(0);
  return *ending_;
}

std::optional<Ending> ChildProcess::waitFor(std::chrono::milliseconds at_most) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  while (!ended() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds{5});
  return ended();
}

void ChildProcess::signal(int number) {
  if (!ended()) kill(pid_, number);
}

void ChildProcess::signalGroup(int number) {
  if (!ended() && kill(-pid_, number) != 0) kill(pid_, number);
}

void ChildProcess::killRemaining() {
  if (ended()) kill(-pid_, SIGKILL);
}

Ending ChildProcess::waitOrKill(std::chrono::milliseconds grace) {
  if (!waitFor(grace)) signal(SIGKILL);
  return wait();
}

void ChildProcess::detach() {
  ending_ = Ending{};
}

}  // namespace darwinop::process
