// darwinop-sound: plays and speaks for one controller, which starts it at its first sound and talks to it through its
// standard input. Ends with that controller.
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

/// Decoders tell developers what they think of a file. What users need to know goes through the socket.
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
        << "darwinop-sound: controllers start this program by themselves when they play or speak (webots::Speaker)\n";
    return 2;
  }
  // Ctrl-C is for the controller, which may go on.
  darwinop::ignoreSignals();
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP}) std::signal(signal, SIG_IGN);
  // A controller may start it from a real-time thread; decoders have no business beside the loop.
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
  // Not /proc/self/exe: on a robot that is the loader.
  const std::string home = std::filesystem::path{arguments[0]}.parent_path();
  // On a robot it brings what ALSA has to be told.
  const std::string card_file = home + "/alsa.conf";
  std::error_code unreadable;
  if (std::filesystem::exists(card_file, unreadable)) setenv("ALSA_CONFIG_PATH", card_file.c_str(), 0);
  silenceLibraries();
  darwinop::audio::serve(0, home);
}
