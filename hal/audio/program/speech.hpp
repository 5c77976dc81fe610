// Speech synthesis with libespeak-ng in a thread of its own: the library is not reentrant and blocks.
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
  /// `data`: the folder that contains espeak-ng-data; empty: the library's default. `report` receives errors, from the
  /// synthesis thread.
  Speech(const std::string& data, std::function<void(const std::string&)> report);
  ~Speech();
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  /// The samples of this text; aborts the previous speech. Null if speech is not available (already reported).
  [[nodiscard]] std::unique_ptr<SoundSource> speak(const Speak& speak);

 private:
  struct Job {
    Speak speak;
    std::shared_ptr<Spoken> to;
  };
  void run();
  void synthesize(const Job& job);
  void choose(const std::string& voice);

  std::function<void(const std::string&)> report_;
  int rate_;  // Hz; 0: speech is not available
  std::shared_ptr<Spoken> spoken_;
  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Job> next_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace darwinop::audio
