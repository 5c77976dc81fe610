// The program that plays and speaks for a controller: found, started at the first sound, talked to through a socket.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/sound_output.hpp"

namespace darwinop::connect {

/// Where the program is looked for, first one first: DARWINOP_SOUND alone if that is set, else beside the running
/// program, else where it was built or installed.
std::vector<std::string> soundProgramPlaces();

/// Starts it. Throws std::runtime_error with what to do when there is none, or DARWINOP_SOUND is "none".
std::unique_ptr<SoundOutput> openSound();

/// `program` is a path. One that has a loader of its own beside it, as on a robot, is started by that.
class SoundProgram final : public SoundOutput {
 public:
  /// Throws std::runtime_error when it cannot be started.
  explicit SoundProgram(const std::string& program);
  /// It ends with its socket; one that does not is killed after half a second.
  ~SoundProgram() override;
  SoundProgram(const SoundProgram&) = delete;
  SoundProgram& operator=(const SoundProgram&) = delete;

  bool order(const SoundOrder& order) override;
  std::optional<SoundEvent> nextEvent(std::chrono::milliseconds wait) override;

  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  std::optional<SoundEvent> lost();
  [[nodiscard]] bool reap(int options);

  int socket_ = -1;
  pid_t pid_ = -1;
  int status_ = 0;  // of the process, once it was reaped
  bool lost_ = false;
  std::vector<std::uint8_t> message_;
};

}  // namespace darwinop::connect
