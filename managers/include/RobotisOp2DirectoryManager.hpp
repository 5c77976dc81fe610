// Directory of the vendor's data files on a ROBOTIS OP2.
#ifndef ROBOTIS_OP2_DIRECTORY_MANAGER_HPP
#define ROBOTIS_OP2_DIRECTORY_MANAGER_HPP

#include <string>

namespace managers {

/// Not a setting: files elsewhere are named in full.
class RobotisOp2DirectoryManager {
 public:
  /// "/robotis/Data/", with the slash, whether it exists or not; the same on a PC. Thread-safe.
  static const std::string& getDataDirectory();
};

}  // namespace managers

#endif
