// Error messages for opening a serial port.
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "core/text/printable.hpp"
#include "hal/cm730/port_messages.hpp"
#include "hal/cm730/serial_open.hpp"

namespace darwinop::cm730 {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& process, const std::string& real) {
  std::error_code error;
  for (fs::directory_iterator it{process / "fd", error}, end; !error && it != end; it.increment(error)) {
    std::error_code unreadable;
    if (fs::read_symlink(it->path(), unreadable) == real) return true;
  }
  return false;
}

/// Id of the process that has locked the file, from the kernel's list; empty: none, or it is not visible here. A line:
/// "3: FLOCK  ADVISORY  WRITE 1234 00:1b:5 0 EOF", with device numbers in hexadecimal.
std::string lockOwner(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return {};
  std::array<char, 64> file{};
  std::snprintf(file.data(), file.size(), "%02x:%02x:%ju", major(info.st_dev), minor(info.st_dev),
                static_cast<std::uintmax_t>(info.st_ino));
  std::ifstream locks{"/proc/locks"};
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words{line};
    std::string number, kind, way, access, pid, locked;
    words >> number >> kind >> way >> access >> pid >> locked;
    if (kind == "FLOCK" && locked == file.data()) return pid;
  }
  return {};
}

constexpr std::string_view kRuntime = "darwinop-runtime";
constexpr std::size_t kLongestName = 15;  // of a process, in the kernel

std::string processName(const std::string& pid) {
  std::string name;
  std::getline(std::ifstream{"/proc/" + pid + "/comm"}, name);
  if (name == kRuntime.substr(0, kLongestName)) return std::string{kRuntime};
  return text::printable(name);  // a process chooses its name
}

/// Id of the process that has locked the port, otherwise of one that has it open: the robot behind a pty has it open as
/// well. The first may have ended and left the lock to a process that it forked. Empty: the descriptors of other users'
/// processes are not readable.
std::string holder(const std::string& path) {
  std::error_code error;
  if (std::string pid = lockOwner(path); !pid.empty() && fs::exists("/proc/" + pid, error)) return pid;
  const std::string real = fs::canonical(path, error).string();
  if (error) return {};
  for (fs::directory_iterator it{"/proc", error}, end; !error && it != end; it.increment(error)) {
    std::string pid = it->path().filename().string();
    if (pid.find_first_not_of("0123456789") != std::string::npos || !holds(it->path(), real)) continue;
    return pid;
  }
  return {};
}

std::string choices() {
  const auto ports = candidatePorts();
  if (ports.empty())
    return "no USB serial port found; check the USB cable and the robot's power switch, or start "
           "`darwinop virtual-robot` and use the path it prints";
  std::string text = "available ports:";
  for (const std::string& port : ports) text += " " + port;
  return text + "; choose one with --robot or DARWINOP_ROBOT";
}

std::string inUse(const std::string& path) {
  const std::string pid = holder(path), in_use = path + kPortInUse;
  if (pid.empty()) return in_use + "another program: find it with `sudo fuser -v " + path + "` and stop it";
  if (pid == std::to_string(::getpid())) return in_use + "this process: stop it first";
  const std::string name = processName(pid);
  return in_use + "process " + pid + " (" + name +
         "): " + (name == kRuntime ? howToStopRuntime(pid) + kDriveThroughRuntime : "stop it first");
}

}  // namespace

std::string howToStopRuntime(const std::string& pid) {
  return "stop it with `darwinop supervisor --stop`, or `kill " + pid + "` where no supervisor runs";
}

void requirePort(const std::string& path) {
  const OpenAttempt tried = openSerial(path);
  if (tried.fd < 0) throw std::runtime_error(explain(path, tried));
  closeSerial(tried.fd);
}

bool mayComeYet(const OpenAttempt& failed) {
  switch (failed.error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case EBUSY:
    case EWOULDBLOCK:
      return true;
    default:
      return false;
  }
}

std::string explain(const std::string& path, const OpenAttempt& failed) {
  using Step = OpenAttempt::Step;
  switch (failed.error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTDIR:
      return "port " + path + kNoSuchPort + "; " + choices();
    case EACCES:
    case EPERM:
      return "no permission to open " + path + ": run `sudo usermod -aG dialout $USER`, then log out and in again";
    case EBUSY:
    case EWOULDBLOCK:
      return inUse(path);
    case ENOTTY:
    case EISDIR:
      return path + kNotASerialPort + "; " + choices();
    default:
      break;
  }
  const std::string reason = std::strerror(failed.error);
  if (failed.step == Step::kTerminal)
    return path + " does not support 1 Mbaud raw mode (" + reason + "): not a CM-730 port; " + choices();
  return "cannot open " + path + ": " + reason + "; unplug the USB cable, plug it in again and retry";
}

std::vector<std::string> candidatePorts(const std::string& dev) {
  std::vector<std::string> ports;
  std::error_code error;
  for (fs::directory_iterator it{dev, error}, end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) ports.push_back(it->path().string());
  }
  std::ranges::sort(ports);
  return ports;
}

}  // namespace darwinop::cm730
