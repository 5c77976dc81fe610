// Sound process: receives commands from a controller's socket until the socket closes.
#include "hal/audio/program/serve.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "hal/audio/program/card.hpp"
#include "hal/audio/program/player.hpp"
#include "hal/audio/program/sound_file.hpp"
#include "hal/audio/program/speech.hpp"
#include "hal/audio/protocol.hpp"

namespace darwinop::audio {

namespace {

class Service {
 public:
  Service(int socket, std::string home) : socket_{socket}, home_{std::move(home)} {}

  void operator()(const PlaySound& play) {
    try {
      double seconds = std::numeric_limits<double>::quiet_NaN();
      if (!player_.with([&](Mixer& mixer) { return mixer.change(play); })) {
        SoundFile file = openSoundFile(play.file);
        seconds = file.seconds / play.pitch;
        if (!player_.with([&](Mixer& mixer) { return mixer.play(play, std::move(file.source)); }))
          throw std::runtime_error("cannot play " + play.file + ": " + std::to_string(kMostSounds) +
                                   " sounds are already playing");
      }
      report(SoundStarted{play.id, seconds});
    } catch (const std::exception& error) {
      refuse(play.id, error.what());
    }
  }

  void operator()(const Speak& speak) {
    // Loaded on first use: takes time and several megabytes.
    if (!speech_)
      speech_ = std::make_unique<Speech>(voicesFolder(), [this](const std::string& what) { report(SoundError{what}); });
    auto voice = speech_->speak(speak);
    if (!voice) return report(SoundEnded{speak.id});
    player_.with([&](Mixer& mixer) {
      mixer.speak(speak, std::move(voice));
      return true;
    });
    report(SoundStarted{speak.id, std::numeric_limits<double>::quiet_NaN()});
  }

  void operator()(const StopSound& stop) {
    player_.with([&](Mixer& mixer) {
      mixer.stop(stop);
      return true;
    });
  }

 private:
  void refuse(SoundId id, const std::string& why) {
    report(SoundError{why});
    report(SoundEnded{id});
  }
  /// Blocks while the controller does not read (a debugger). A closed peer is detected by recv() in serve().
  void report(const SoundEvent& event) {
    const Message message = encode(event);
    while (send(socket_, message.data(), message.size(), MSG_NOSIGNAL) < 0 && errno == EINTR) continue;
  }
  [[nodiscard]] std::string voicesFolder() const {
    std::error_code unreadable;
    return std::filesystem::exists(home_ + "/espeak-ng-data", unreadable) ? home_ : "";
  }

  int socket_;
  std::string home_;
  SoundPlayer player_{[this](const SoundEvent& event) { report(event); }};
  std::unique_ptr<Speech> speech_;
};

}  // namespace

void serve(int socket, const std::string& home) {
  {
    Service service{socket, home};
    std::vector<std::uint8_t> message(kLongestMessage);
    for (;;) {
      const ssize_t size = recv(socket, message.data(), message.size(), 0);
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) break;
      const auto order = decodeOrder({message.data(), static_cast<std::size_t>(size)});
      if (order) std::visit(service, *order);
    }
    // If the card's driver hangs, the default action of SIGALRM ends this process.
    shutdown(socket, SHUT_RDWR);
    alarm(2);
  }
  forgetCards();
}

}  // namespace darwinop::audio
