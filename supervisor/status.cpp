// Status file of the supervisor.
#include "supervisor/status.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>

#include "runtime/shared_file.hpp"

namespace darwinop::supervisor {
namespace {

std::string oneLine(std::string text) {
  for (char& letter : text)
    if (letter == '\n') letter = ' ';
  return text;
}

/// Empty if there is no such file, or if another user created it.
std::string textOf(const std::string& path) try {
  constexpr std::size_t kMost = 16'384;
  const auto file = runtime::openShared(path, O_RDONLY, runtime::FileOwner::kOwn);
  if (!file) return {};
  std::string text(kMost, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(pread(file->fd(), text.data(), kMost, 0), 0)));
  return text;
} catch (const std::runtime_error&) {
  return {};
}

}  // namespace

bool writeStatus(const Status& status, const std::string& path) {
  std::ostringstream text;
  text << "home " << oneLine(status.home) << "\nstate " << oneLine(status.state) << "\ncontroller "
       << oneLine(status.controller) << "\nruntime_pid " << status.runtime_pid << "\ncontroller_pid "
       << status.controller_pid << "\ncrashes " << status.crashes << "\norders " << status.orders << "\nleft "
       << oneLine(status.left) << "\nat_rest " << status.at_rest << "\nstopping " << status.stopping << "\nstays_ended "
       << status.stays_ended << "\ncontroller_ended " << status.controller_ended << '\n';
  std::string fresh = path + ".XXXXXX";  // a name that no other user can take beforehand
  const int fd = mkostemp(fresh.data(), O_CLOEXEC);
  if (fd < 0) return false;
  const std::string bytes = text.str();
  const bool written =
      fchmod(fd, 0644) == 0 && ::write(fd, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  close(fd);
  const auto replaces = [&] { return rename(fresh.c_str(), path.c_str()) == 0; };
  if (written && (replaces() || (runtime::removeAny(path) && replaces()))) return true;
  unlink(fresh.c_str());
  return false;
}

std::optional<Status> readStatus(const std::string& path) {
  std::istringstream file{textOf(path)};
  std::map<std::string, std::string> found;
  for (std::string name, value; file >> name && file.get() && std::getline(file, value);) found[name] = value;
  if (!found.contains("controller_ended")) return std::nullopt;  // the last line
  const auto number = [&](const char* name) { return std::strtol(found[name].c_str(), nullptr, 10); };
  Status status;
  status.home = found["home"];
  status.state = found["state"];
  status.controller = found["controller"];
  status.runtime_pid = static_cast<pid_t>(number("runtime_pid"));
  status.controller_pid = static_cast<pid_t>(number("controller_pid"));
  status.crashes = static_cast<std::size_t>(number("crashes"));
  status.orders = static_cast<std::uint32_t>(number("orders"));
  status.left = found["left"];
  status.at_rest = number("at_rest") != 0;
  status.stopping = number("stopping") != 0;
  status.stays_ended = number("stays_ended") != 0;
  status.controller_ended = number("controller_ended") != 0;
  return status;
}

}  // namespace darwinop::supervisor
