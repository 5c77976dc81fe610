#include "connect/setting.hpp"

#include <sys/stat.h>

#include <charconv>
#include <stdexcept>
#include <string_view>

#include "connect/robot_file.hpp"
#include "runtime/daemon_link.hpp"

namespace darwinop::connect {
namespace {

bool exists(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0;
}

Setting whateverIsThere() {
  if (runtime::daemonPid(runtime::RuntimeFiles{}) != 0) return {RobotKind::kDaemon, {}, {}, {}};
  const std::string port = readRobotFile().serialPort();
  if (exists(port)) return {RobotKind::kSerial, port, {}, {}};
  throw std::runtime_error("no robot found: no runtime daemon is running and " + port +
                           " does not exist. Connect the robot, or say which one is meant with DARWINOP_ROBOT or "
                           "--robot:\n" +
                           settingChoices());
}

constexpr std::string_view kTcpScheme = "tcp://";

/// Parses "tcp://HOST[:PORT]".
Address addressIn(const std::string& text) {
  const auto refuse = [&text](const std::string& why) -> void {
    throw std::runtime_error("'" + text + "' " + why + ". Give it as tcp://HOST or tcp://HOST:PORT, such as " +
                             "tcp://192.168.123.1");
  };
  Address address;
  address.host = text.substr(kTcpScheme.size());
  if (address.host.find('@') != std::string::npos)
    throw std::runtime_error("'" + text +
                             "' names a user, and only `darwinop run` logs in for you: darwinop run "
                             "--robot " +
                             text + " CONTROLLER. A controller by itself needs tcp://HOST[:PORT]");
  if (const auto colon = address.host.find(':'); colon != std::string::npos) {
    const std::string port = address.host.substr(colon + 1);
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
    if (error != std::errc{} || end != port.data() + port.size() || address.port == 0)
      refuse("has no port behind the colon: 1 to 65535");
    address.host.resize(colon);
  }
  if (address.host.empty() || address.host.find_first_of("/ ") != std::string::npos) refuse("names no computer");
  return address;
}

}  // namespace

std::string settingChoices() {
  return "  runtime        the daemon on this computer (start it with: darwinop runtime)\n"
         "  /dev/ttyUSB0   a robot on a serial port; any device or pty\n"
         "  virtual        a virtual robot in this process, in simulated time\n"
         "  twin[:MODEL]   the same with physics; MODEL: darwin-op, webots-2013, or an INI file of your own\n"
         "  tcp://HOST     a robot whose `darwinop remote` listens on HOST; or tcp://HOST:PORT";
}

std::optional<std::string> twinModel(const std::string& text) {
  if (text == "twin") return "";
  if (text.starts_with("twin:") && text.size() > 5) return text.substr(5);
  return std::nullopt;
}

Setting readSetting(const std::string& text) {
  if (text.empty()) return whateverIsThere();
  if (text == "runtime") return {RobotKind::kDaemon, {}, {}, {}};
  if (text == "virtual") return {RobotKind::kVirtual, {}, {}, {}};
  if (const auto model = twinModel(text)) return {RobotKind::kTwin, {}, *model, {}};
  if (text.starts_with(kTcpScheme)) return {RobotKind::kTcp, {}, {}, addressIn(text)};
  if (text.find('/') != std::string::npos && text.find("://") == std::string::npos)
    return {RobotKind::kSerial, text, {}, {}};
  throw std::runtime_error("'" + text +
                           "' is not a robot that this version supports. DARWINOP_ROBOT or --robot can be:\n" +
                           settingChoices());
}

}  // namespace darwinop::connect
