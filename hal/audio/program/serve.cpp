// The sound program: takes orders from a controller's socket until that closes.
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
          throw std::runtime_error("more than " + std::to_string(kMostSounds) + " sounds at once: " + play.file +
                                   " is left out");
      }
      tell(SoundStarted{play.id, seconds});
    } catch (const std::exception& error) {
      refuse(play.id, error.what());
    }
  }

  void operator()(const Speak& speak) {
    // At the first word: the data of the voices take a moment, and some megabytes.
    if (!speech_)
      speech_ = std::make_unique<Speech>(voicesFolder(), [this](const std::string& what) { tell(SoundTrouble{what}); });
    auto voice = speech_->speak(speak);
    if (!voice) return tell(SoundEnded{speak.id});
    player_.with([&](Mixer& mixer) {
      mixer.speak(speak, std::move(voice));
      return true;
    });
    tell(SoundStarted{speak.id, std::numeric_limits<double>::quiet_NaN()});
  }

  void operator()(const StopSound& stop) {
    player_.with([&](Mixer& mixer) {
      mixer.stop(stop);
      return true;
    });
  }

 private:
  void refuse(SoundId id, const std::string& why) {
    tell(SoundTrouble{why});
    tell(SoundEnded{id});
  }
  /// Waits when the controller reads nothing, as in a debugger; whoever has gone is noticed where orders are read.
  void tell(const SoundNews& news) {
    const Message message = encode(news);
    while (send(socket_, message.data(), message.size(), MSG_NOSIGNAL) < 0 && errno == EINTR) continue;
  }
  [[nodiscard]] std::string voicesFolder() const {
    std::error_code unreadable;
    return std::filesystem::exists(home_ + "/espeak-ng-data", unreadable) ? home_ : "";
  }

  int socket_;
  std::string home_;
  Player player_{[this](const SoundNews& news) { tell(news); }};
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
    // A card that hangs must not keep this process: the default action of the signal ends it.
    shutdown(socket, SHUT_RDWR);
    alarm(2);
  }
  forgetCards();
}

}  // namespace darwinop::audio
