// Runs gnuplot without a shell: script on standard input, picture on standard output.
#include "experiments/logs/plot/gnuplot.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/text.hpp"
#include "hal/process/child_process.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::plot {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file instead of a pipe: no deadlock, and gnuplot may end early.
File temporaryFile() {
  File file{std::tmpfile(), &std::fclose};
  if (!file) throw std::runtime_error(std::string{"cannot create a temporary file: "} + std::strerror(errno));
  return file;
}

std::string contentOf(std::FILE* file) {
  std::string content;
  std::array<char, 65536> part{};
  std::fseek(file, 0, SEEK_SET);
  for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), file)) > 0;)
    content.append(part.data(), size);
  return content;
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

/// 0: success; a positive errno: did not start; -1: failed.
int run(int input, int output, int errors) try {
  using process::Stream;
  // --default-settings ignores ~/.gnuplot.
  process::ChildProcess gnuplot{{.command = {"gnuplot", "--default-settings", "-"},
                                 .streams = {Stream::copyOf(input), Stream::copyOf(output), Stream::copyOf(errors)}}};
  return gnuplot.wait().isNormal() ? 0 : -1;
} catch (const std::system_error& error) {
  return error.code().value();
}

}  // namespace

std::string drawPicture(const Figure& figure, const std::string& path) {
  const File picture = temporaryFile();
  const File script = temporaryFile(), errors = temporaryFile();
  const std::string commands = gnuplotScript(figure);
  if (std::fwrite(commands.data(), 1, commands.size(), script.get()) != commands.size() ||
      std::fflush(script.get()) != 0)
    throw std::runtime_error(std::string{"cannot write a temporary file: "} + std::strerror(errno));
  std::rewind(script.get());
  const int result = run(fileno(script.get()), fileno(picture.get()), fileno(errors.get()));
  if (result == 0) {
    writeTextFile(path, contentOf(picture.get()));
    return "";
  }
  if (result == ENOENT) return "no picture " + path + ": " + messages::kGnuplotMissing;
  if (result > 0) return "no picture " + path + ": cannot start gnuplot: " + std::strerror(result);
  return "no picture " + path + ": gnuplot error: " + firstLineOf(errors.get());
}

}  // namespace darwinop::plot
