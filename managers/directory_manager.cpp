// Data folders of the two robot generations.
#include "DARwInOPDirectoryManager.hpp"
#include "RobotisOp2DirectoryManager.hpp"

namespace managers {

const std::string& DARwInOPDirectoryManager::getDataDirectory() {
  static const std::string directory = "/darwin/Data/";
  return directory;
}

const std::string& RobotisOp2DirectoryManager::getDataDirectory() {
  static const std::string directory = "/robotis/Data/";
  return directory;
}

}  // namespace managers
