// Text becomes speech, in a thread of its own: libespeak-ng has one voice at a time and takes its time.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "hal/audio/program/spoken.hpp"
#include "hal/sound_output.hpp"

namespace darwinop::audio {

class Speech {
 public:
  /// `data` is the folder that holds espeak-ng-data, empty: where the library looks by itself. `trouble` is told, from
  /// another thread, what could not be said as asked for.
  Speech(const std::string& data, std::function<void(const std::string&)> trouble);
  ~Speech();
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  /// What it will give; ends what was spoken before. Empty when there is no speech here, which was told.
  [[nodiscard]] std::unique_ptr<SoundSource> speak(const Speak& speak);

 private:
  struct Job {
    Speak speak;
    std::shared_ptr<Spoken> to;
  };
  void run();
  void say(const Job& job);
  void choose(const std::string& voice);

  std::function<void(const std::string&)> trouble_;
  int rate_;  // Hz; 0: no speech
  std::shared_ptr<Spoken> spoken_;
  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Job> next_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace darwinop::audio
