// darwinop-sound: sound and speech for one controller, which starts it at its first sound and sends commands through
// its standard input. Ends with that controller.
#include <fcntl.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "hal/audio/program/serve.hpp"
#include "hal/signals.hpp"

namespace {

/// Discards decoder messages, which are for developers; errors for users go through the socket.
void silenceLibraries() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, 2);
#endif
}

}  // namespace

int main(int, char** arguments) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(0, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_SEQPACKET) {
    std::cerr
        << "darwinop-sound: this program is started by controllers that play sounds or speech (webots::Speaker)\n";
    return 2;
  }
  // Ctrl-C is handled by the controller, which may continue.
  darwinop::ignoreSignals();
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP}) std::signal(signal, SIG_IGN);
  // The parent thread may be real-time; decoders must not compete with the loop.
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
  // Not /proc/self/exe: on a robot that is the dynamic loader.
  const std::string home = std::filesystem::path{arguments[0]}.parent_path();
  // On a robot the ALSA configuration is beside the program.
  const std::string card_file = home + "/alsa.conf";
  std::error_code unreadable;
  if (std::filesystem::exists(card_file, unreadable)) setenv("ALSA_CONFIG_PATH", card_file.c_str(), 0);
  silenceLibraries();
  darwinop::audio::serve(0, home);
}
