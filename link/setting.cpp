#include "link/setting.hpp"

#include <sys/stat.h>

#include <stdexcept>

#include "link/robot_file.hpp"
#include "runtime/daemon_link.hpp"

namespace darwinop::link {
namespace {

bool exists(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0;
}

Setting whateverIsThere() {
  if (runtime::daemonPid(runtime::RuntimeFiles{}) != 0) return {Kind::kDaemon, {}, {}};
  const std::string port = readRobotFile().serialPort();
  if (exists(port)) return {Kind::kSerial, port, {}};
  throw std::runtime_error("no robot found: no runtime daemon is running and " + port +
                           " does not exist. Connect the robot, or say which one is meant with DARWINOP_ROBOT or "
                           "--robot:\n" +
                           settingChoices());
}

}  // namespace

std::string settingChoices() {
  return "  runtime        the daemon on this computer (start it with: darwinop runtime)\n"
         "  /dev/ttyUSB0   a robot on a serial port; any device or pty\n"
         "  virtual        a virtual robot in this process, in simulated time\n"
         "  twin[:MODEL]   the same with physics; MODEL: darwin-op, webots-2013, or an INI file of your own";
}

std::optional<std::string> twinModel(const std::string& text) {
  if (text == "twin") return "";
  if (text.starts_with("twin:") && text.size() > 5) return text.substr(5);
  return std::nullopt;
}

Setting readSetting(const std::string& text) {
  if (text.empty()) return whateverIsThere();
  if (text == "runtime") return {Kind::kDaemon, {}, {}};
  if (text == "virtual") return {Kind::kVirtual, {}, {}};
  if (const auto model = twinModel(text)) return {Kind::kTwin, {}, *model};
  if (text.find('/') != std::string::npos && text.find("://") == std::string::npos) return {Kind::kSerial, text, {}};
  throw std::runtime_error("'" + text + "' is no robot this version knows. DARWINOP_ROBOT or --robot can be:\n" +
                           settingChoices());
}

}  // namespace darwinop::link
