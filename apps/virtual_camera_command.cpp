#include "virtual_camera_command.hpp"

#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "hal/signals.hpp"

namespace darwinop::app {

pid_t startWith(std::vector<std::string> environment, const std::vector<std::string>& command) {
  for (char** one = environ; *one != nullptr; ++one) {
    const std::string text = *one, name = text.substr(0, text.find('=') + 1);
    if (std::ranges::none_of(environment, [&](const std::string& set) { return set.starts_with(name); }))
      environment.push_back(text);
  }
  std::vector<char*> words, variables;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  for (const std::string& variable : environment) variables.push_back(const_cast<char*>(variable.c_str()));
  words.push_back(nullptr);
  variables.push_back(nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  sigset_t ignored = none;
  for (const int signal : kIgnoredSignals) sigaddset(&ignored, signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) sigaddset(&ignored, signal);
  posix_spawnattr_setsigdefault(&attributes, &ignored);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t child = -1;
  const int error = posix_spawnp(&child, words[0], nullptr, &attributes, words.data(), variables.data());
  posix_spawnattr_destroy(&attributes);
  if (error == 0) return child;
  std::fprintf(stderr, "darwinop-virtual-camera: cannot start %s: %s\n", words[0], std::strerror(error));
  return -1;
}

}  // namespace darwinop::app
