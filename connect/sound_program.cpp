// The program that plays and speaks for a controller: found, started at the first sound, talked to through a socket.
#include "connect/sound_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "hal/audio/protocol.hpp"

#ifndef DARWINOP_SOUND_FOLDERS
#error "tools/cmake/Package.cmake says where the sound program is built and installed"
#endif

namespace darwinop::connect {

namespace {

namespace fs = std::filesystem;
constexpr const char* kVariable = "DARWINOP_SOUND";
constexpr const char* kProgram = "darwinop-sound";

/// The command line: a robot's program lies beside a loader and libraries that its system does not have.
std::vector<std::string> commandFor(const fs::path& program) {
  const fs::path loader = program.parent_path() / "ld-linux.so.2";
  std::error_code unreadable;
  if (!fs::exists(loader, unreadable)) return {program};
  return {loader, "--library-path", program.parent_path(), program};
}

/// Its standard input is the socket. It gets nothing else of ours: no signal that is held back or handled, and no
/// descriptor but standard error, whatever the controller has open: a pipe ends when the controller closes it.
pid_t startWith(int socket, std::vector<std::string> command) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, 3);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  pid_t pid = -1;
  const int failed = posix_spawn(&pid, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw std::runtime_error("the sound program " + command.back() + " cannot be started: " + std::strerror(failed));
  return pid;
}

std::string howItEnded(int status) {
  if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::vector<std::string> soundProgramPlaces() {
  if (const char* const said = std::getenv(kVariable); said != nullptr && *said != '\0')
    return {fs::absolute(said).string()};
  std::error_code unknown;
  std::vector<std::string> places{fs::read_symlink("/proc/self/exe", unknown).parent_path() / kProgram};
  for (const char* const folder : {DARWINOP_SOUND_FOLDERS})
    if (const std::string place = fs::path{folder} / kProgram; places.back() != place) places.push_back(place);
  return places;
}

std::unique_ptr<SoundOutput> openSound() {
  if (const char* const said = std::getenv(kVariable); said != nullptr && std::string_view{said} == "none")
    throw std::runtime_error(std::string{kVariable} + " is \"none\"");
  std::string looked;
  for (const std::string& place : soundProgramPlaces()) {
    if (access(place.c_str(), X_OK) == 0) return std::make_unique<SoundProgram>(place);
    looked += "\n  " + place;
  }
  throw std::runtime_error("sound is made by a program of its own, " + std::string{kProgram} +
                           ", and it was not found. Looked for:" + looked + "\nSay with " + kVariable + " where it is");
}

SoundProgram::SoundProgram(const std::string& program) : message_(audio::kLongestMessage) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error(std::string{"no socket for the sound program: "} + std::strerror(errno));
  socket_ = ends[0];
  try {
    pid_ = startWith(ends[1], commandFor(program));
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
}

SoundProgram::~SoundProgram() {
  close(socket_);
  for (int i = 0; i < 50; ++i) {
    if (reap(WNOHANG)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  kill(pid_, SIGKILL);
  static_cast<void>(reap(0));
}

/// True: it has ended, and is not a zombie.
bool SoundProgram::reap(int options) {
  if (pid_ < 0) return true;
  pid_t reaped = 0;
  while ((reaped = waitpid(pid_, &status_, options)) < 0 && errno == EINTR) continue;
  if (reaped == 0) return false;
  pid_ = -1;  // or the controller, which waits for all its children, has done it
  return true;
}

bool SoundProgram::order(const SoundOrder& order) {
  const audio::Message message = audio::encode(order);
  // One that has died is noticed where events are read.
  return send(socket_, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0 || errno == EPIPE ||
         errno == ECONNRESET;
}

std::optional<SoundEvent> SoundProgram::nextEvent(std::chrono::milliseconds wait) {
  if (lost_) return std::nullopt;
  if (wait.count() > 0) {
    pollfd waiting{socket_, POLLIN, 0};
    poll(&waiting, 1, static_cast<int>(wait.count()));
  }
  for (;;) {
    const ssize_t size = recv(socket_, message_.data(), message_.size(), MSG_DONTWAIT);
    if (size < 0 && (errno == EINTR)) continue;
    if (size < 0 && errno == EAGAIN) return std::nullopt;
    if (size <= 0) return lost();
    if (auto event = audio::decodeEvent({message_.data(), static_cast<std::size_t>(size)})) return event;
  }
}

std::optional<SoundEvent> SoundProgram::lost() {
  lost_ = true;
  // Its socket is closed a moment before it can be reaped.
  for (int i = 0; i < 50 && !reap(WNOHANG); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  return SoundLost{"the sound program " + (pid_ < 0 ? howItEnded(status_) : std::string{"does not answer"}) +
                   "; sounds are cut off, the next one starts it again"};
}

}  // namespace darwinop::connect
