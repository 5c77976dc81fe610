// Managers whose insides come later: their interfaces, so that controllers that use them build.
#include "DARwInOPDirectoryManager.hpp"
#include "DARwInOPMotionManager.hpp"
#include "RobotisOp2DirectoryManager.hpp"
#include "webots/notices.hpp"

namespace managers {

using darwinop::facade::warnOnce;

DARwInOPMotionManager::DARwInOPMotionManager(webots::Robot*, const std::string&) {
  warnOnce("MotionManager: this version cannot play pages yet; every call returns at once");
}

void DARwInOPMotionManager::playPage(int id, bool) {
  warnOnce("MotionManager: page " + std::to_string(id) + " is skipped");
}

const std::string& DARwInOPDirectoryManager::getDataDirectory() {
  static const std::string directory = "/darwin/Data/";
  return directory;
}

const std::string& RobotisOp2DirectoryManager::getDataDirectory() {
  static const std::string directory = "/robotis/Data/";
  return directory;
}

}  // namespace managers
