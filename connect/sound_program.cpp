// Child process for sound and speech.
#include "connect/sound_program.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "hal/audio/protocol.hpp"

#ifndef DARWINOP_SOUND_FOLDERS
#error "tools/cmake/Package.cmake says where the sound program is built and installed"
#endif

namespace darwinop::connect {

namespace {

namespace fs = std::filesystem;
constexpr const char* kVariable = "DARWINOP_SOUND";
constexpr const char* kProgram = "darwinop-sound";

/// Command line. On a robot the program comes with its own libraries and their loader, by this name whatever the
/// architecture.
std::vector<std::string> commandFor(const fs::path& program) {
  const fs::path loader = program.parent_path() / "ld-linux.so.2";
  std::error_code unreadable;
  if (!fs::exists(loader, unreadable)) return {program};
  return {loader, "--library-path", program.parent_path(), program};
}

/// Standard input is the socket. The program inherits no signal mask, no handlers and no descriptors but standard
/// error: a pipe of the controller must end when the controller closes it.
process::Start startOf(const std::string& program, int socket) {
  using process::Stream;
  return {
      .command = commandFor(program), .streams = {Stream::copyOf(socket), Stream::nothing()}, .closes_others = true};
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
    process_.emplace(startOf(program, ends[1]));
  } catch (const std::system_error& error) {
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error("the sound program " + program +
                             " cannot be started: " + std::strerror(error.code().value()));
  }
  close(ends[1]);
}

SoundProgram::~SoundProgram() {
  close(socket_);
  (void)process_->waitOrKill(std::chrono::milliseconds{500});
}

bool SoundProgram::order(const SoundOrder& order) {
  const audio::Message message = audio::encode(order);
  // nextEvent() detects a program that has died.
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
  // The socket closes shortly before the process can be reaped.
  const std::optional<process::Ending> ending = process_->waitFor(std::chrono::milliseconds{50});
  return SoundLost{"the sound program " + (ending ? "ended " + describe(*ending) : std::string{"does not answer"}) +
                   "; sounds are cut off, the next one starts it again"};
}

}  // namespace darwinop::connect
