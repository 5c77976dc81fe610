// The real sound program on a graph of ALSA that ends in a WAV file instead of a card.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "connect/sound_program.hpp"
#include "support/temporary_folder.hpp"
#include "support/wave.hpp"

namespace darwinop {

inline constexpr std::chrono::milliseconds kPatience{20'000};  // a machine that is busy; nothing waits for all of it

class SoundGraph : public testing::Test {
 protected:
  SoundGraph() {
    writeGraph(
        "pcm.!default { type plug; slave.pcm \"recorder\" }\n"
        "pcm.recorder { type file; slave.pcm \"nowhere\"; file \"" +
        recording() +
        "\"; format \"wav\" }\n"
        "pcm.nowhere { type null }\n");
    setenv("ALSA_CONFIG_PATH", (folder / "alsa.conf").c_str(), 1);
    setenv("DARWINOP_SOUND", DARWINOP_SOUND_PROGRAM, 1);
  }

  void writeGraph(const std::string& text) const { std::ofstream{folder / "alsa.conf"} << text; }
  [[nodiscard]] std::string recording() const { return folder / "out.wav"; }
  /// A tone of 16 bits at 22050 Hz.
  std::string toneFile(double hertz, double duration, double amplitude = 0.5) {
    std::string name = folder / (std::to_string(hertz) + ".wav");
    writeWave(name, {.rate = 22050, .channels = 1, .samples = tone(hertz, duration, amplitude, 22050)});
    return name;
  }

  connect::SoundProgram& sound() {
    if (!sound_) sound_ = std::make_unique<connect::SoundProgram>(DARWINOP_SOUND_PROGRAM);
    return *sound_;
  }
  /// Other events meanwhile are kept.
  void awaitEnd(SoundId id) {
    await([&](const SoundEvent& event) { return event == SoundEvent{SoundEnded{id}}; });
  }
  void awaitBegin(SoundId id) {
    await([&](const SoundEvent& event) {
      const auto* const started = std::get_if<SoundStarted>(&event);
      return started != nullptr && started->id == id;
    });
  }
  /// Two threads report them, so they come in either order.
  void awaitBeginAndError() {
    bool has_begun = false, has_failed = false;
    await([&](const SoundEvent& event) {
      has_begun = has_begun || std::holds_alternative<SoundStarted>(event);
      has_failed = has_failed || std::holds_alternative<SoundError>(event);
      return has_begun && has_failed;
    });
  }
  /// Ends the program; sound() starts the next one.
  void endProgram() { sound_.reset(); }
  /// Ends the program and reads what it has played.
  Wave recorded() {
    endProgram();
    return readWave(recording());
  }

  TemporaryFolder folder;
  std::string said;    // errors
  double seconds = 0;  // of the sound that began last

 private:
  template <class Condition>
  void await(Condition is_it) {
    while (const auto event = sound().nextEvent(kPatience)) {
      if (const auto* const error = std::get_if<SoundError>(&*event)) said += error->sentence + '\n';
      if (const auto* const started = std::get_if<SoundStarted>(&*event)) seconds = started->seconds;
      if (is_it(*event)) return;
    }
    FAIL() << "no further event; before that: " << said;
  }

  std::unique_ptr<connect::SoundProgram> sound_;
};

}  // namespace darwinop
