// Detects whether a robot setting may refer to hardware.
#include "experiments/run/hardware.hpp"

#include <filesystem>
#include <fstream>

#include "connect/setting.hpp"

namespace darwinop::experiments {
namespace {

namespace fs = std::filesystem;

/// True if this process holds the master of /dev/pts/`number`. Requires Linux 4.13 ("tty-index"); false before that.
bool holdsOtherEnd(const fs::path& process, const std::string& number) {
  std::error_code unreadable;
  for (const auto& file : fs::directory_iterator{process / "fdinfo", unreadable}) {
    std::ifstream info{file.path()};
    for (std::string word; info >> word;)
      if (word == "tty-index:" && info >> word && word == number) return true;
  }
  return false;
}

/// A pty is not sufficient: a network bridge to a robot also has one.
bool isVirtualRobot(const std::string& port) {
  std::error_code unknown;
  const fs::path device = fs::canonical(port, unknown);
  if (unknown || device.parent_path() != "/dev/pts") return false;
  for (const auto& process : fs::directory_iterator{"/proc", unknown}) {
    const fs::path program = fs::read_symlink(process.path() / "exe", unknown).filename();
    const bool ours = program == "darwinop-virtual-robot" || program == "darwinop-twin";
    if (ours && holdsOtherEnd(process.path(), device.filename())) return true;
  }
  return false;
}

}  // namespace

bool mayBeHardware(const std::string& setting) {
  const connect::Setting robot = connect::readSetting(setting);
  if (robot.kind == connect::RobotKind::kSerial) return !isVirtualRobot(robot.port);
  return connect::loopIsElsewhere(robot);
}

}  // namespace darwinop::experiments
