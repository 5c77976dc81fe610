// Where a ROBOTIS OP2 keeps its data files.
#ifndef ROBOTIS_OP2_DIRECTORY_MANAGER_HPP
#define ROBOTIS_OP2_DIRECTORY_MANAGER_HPP

#include <string>

namespace managers {

class RobotisOp2DirectoryManager {
 public:
  static const std::string& getDataDirectory();
};

}  // namespace managers

#endif
