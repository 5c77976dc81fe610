#include "hil-mocks/link_owner.hpp"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace darwinop::hil {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kName = "darwinop-virtua";  // the kernel keeps 15 letters of darwinop-virtual-robot

std::string firstLine(const fs::path& file) {
  std::string line;
  std::getline(std::ifstream{file}, line);
  return line;
}

/// The process has opened the master of pseudo terminal `number`; its fdinfo has a line "tty-index: 3".
bool isMaster(const fs::path& process, const std::string& number) {
  std::error_code unreadable;
  for (fs::directory_iterator it{process / "fdinfo", unreadable}, end; !unreadable && it != end;
       it.increment(unreadable)) {
    std::ifstream file{it->path()};
    for (std::string key, value; file >> key && std::getline(file >> std::ws, value);)
      if (key == "tty-index:" && value == number) return true;
  }
  return false;
}

}  // namespace

std::string linkOwner(const std::string& path) {
  std::error_code error;
  const fs::path terminal = fs::read_symlink(path, error);
  if (error || terminal.parent_path() != "/dev/pts" || !fs::exists(terminal, error)) return {};
  for (fs::directory_iterator it{"/proc", error}, end; !error && it != end; it.increment(error))
    if (firstLine(it->path() / "comm") == kName && isMaster(it->path(), terminal.filename().string()))
      return it->path().filename().string();
  return {};
}

}  // namespace darwinop::hil
