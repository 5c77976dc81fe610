// Managers whose insides come later: their interfaces, so that controllers that use them build.
#include "DARwInOPDirectoryManager.hpp"
#include "DARwInOPGaitManager.hpp"
#include "RobotisOp2DirectoryManager.hpp"
#include "webots/notices.hpp"

namespace managers {

using darwinop::facade::warnOnce;

DARwInOPGaitManager::DARwInOPGaitManager(webots::Robot*, const std::string&) {
  warnOnce("GaitManager: this version cannot walk yet; every call does nothing");
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
