// Where the robot keeps its data files.
#ifndef DARWIN_OP_DIRECTORY_MANAGER_HPP
#define DARWIN_OP_DIRECTORY_MANAGER_HPP

#include <string>

namespace managers {

class DARwInOPDirectoryManager {
 public:
  static const std::string& getDataDirectory();
};

}  // namespace managers

#endif
