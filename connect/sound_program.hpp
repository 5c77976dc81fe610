// Child process for sound and speech: found, started at the first sound, controlled through a socket.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/process/child_process.hpp"
#include "hal/sound_output.hpp"

namespace darwinop::connect {

/// Paths to try, in order: only DARWINOP_SOUND if set, else beside the running program, else where it was built or
/// installed.
std::vector<std::string> soundProgramPlaces();

/// Starts the program. Throws std::runtime_error with a remedy if it is not found or DARWINOP_SOUND is "none".
std::unique_ptr<SoundOutput> openSound();

/// If there is a dynamic loader beside the program, as on a robot, it starts the program.
class SoundProgram final : public SoundOutput {
 public:
  /// `program`: path. Throws std::runtime_error if it cannot be started.
  explicit SoundProgram(const std::string& program);
  /// Closes the socket, which ends the program; kills it after half a second if it does not end.
  ~SoundProgram() override;
  SoundProgram(const SoundProgram&) = delete;
  SoundProgram& operator=(const SoundProgram&) = delete;

  bool order(const SoundOrder& order) override;
  std::optional<SoundEvent> nextEvent(std::chrono::milliseconds wait) override;

  [[nodiscard]] pid_t pid() const { return process_->pid(); }

 private:
  std::optional<SoundEvent> lost();

  int socket_ = -1;
  std::optional<process::ChildProcess> process_;
  bool lost_ = false;
  std::vector<std::uint8_t> message_;
};

}  // namespace darwinop::connect
