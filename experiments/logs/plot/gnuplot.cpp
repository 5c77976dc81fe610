// Runs gnuplot: no shell, script on its standard input, picture on its standard output.
#include "experiments/logs/plot/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "experiments/logs/plot/text.hpp"

namespace darwinop::plot {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file and not a pipe: nobody waits for the other, and gnuplot may end early.
File scratch() {
  File file{std::tmpfile(), &std::fclose};
  if (!file) throw std::runtime_error(std::string{"cannot make a temporary file: "} + std::strerror(errno));
  return file;
}

std::string firstLineOf(std::FILE* file) {
  std::array<char, 400> text{};
  std::rewind(file);
  while (std::fgets(text.data(), text.size(), file) != nullptr) {
    std::string line = oneLine(std::string_view{text.data()}.substr(0, std::strcspn(text.data(), "\n")));
    if (line.find_first_not_of(" ^") != std::string::npos) return line;
  }
  return "";
}

/// 0: ended well; ENOENT and others: did not start; -1: failed.
int run(int input, int output, int errors) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  // --default-settings: no ~/.gnuplot, so that a picture looks the same everywhere.
  std::array<std::string, 3> words{"gnuplot", "--default-settings", "-"};
  std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
  pid_t child = -1;
  const int error = posix_spawnp(&child, "gnuplot", &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) return error;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : -1;
}

}  // namespace

std::string drawPicture(const Figure& figure, const std::string& path) {
  const File picture{std::fopen(path.c_str(), "wbe"), &std::fclose};
  if (!picture)
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno) + "; name another place with -o");
  const File script = scratch(), errors = scratch();
  const std::string commands = gnuplotScript(figure);
  if (std::fwrite(commands.data(), 1, commands.size(), script.get()) != commands.size() ||
      std::fflush(script.get()) != 0)
    throw std::runtime_error(std::string{"cannot write a temporary file: "} + std::strerror(errno));
  std::rewind(script.get());
  const int result = run(fileno(script.get()), fileno(picture.get()), fileno(errors.get()));
  if (result == 0) return "";
  (void)std::remove(path.c_str());
  if (result == ENOENT) return "no picture " + path + ": gnuplot is not installed (apt-get install gnuplot-nox)";
  if (result > 0) return "no picture " + path + ": gnuplot does not start: " + std::strerror(result);
  return "no picture " + path + ": gnuplot said: " + firstLineOf(errors.get());
}

}  // namespace darwinop::plot
