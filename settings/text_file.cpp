#include "settings/text_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace darwinop::settings {

std::optional<std::string> readTextFile(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::fopen(path.c_str(), "rb"), &std::fclose};
  if (!file && errno == ENOENT) return std::nullopt;
  std::string text;
  std::array<char, 4096> part{};
  while (file) {
    const std::size_t size = std::fread(part.data(), 1, part.size(), file.get());
    text.append(part.data(), size);
    if (size == 0) break;
  }
  if (!file || std::ferror(file.get()))
    throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno) +
                             "; make it a file that you may read (chmod a+r), or remove it to use the defaults");
  return text;
}

}  // namespace darwinop::settings
