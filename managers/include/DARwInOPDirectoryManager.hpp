// Directory of the vendor's data files on a DARwIn-OP.
#ifndef DARWIN_OP_DIRECTORY_MANAGER_HPP
#define DARWIN_OP_DIRECTORY_MANAGER_HPP

#include <string>

namespace managers {

/// Not a setting: files elsewhere are named in full.
class DARwInOPDirectoryManager {
 public:
  /// "/darwin/Data/", with the slash, whether it exists or not; the same on a PC. Thread-safe.
  static const std::string& getDataDirectory();
};

}  // namespace managers

#endif
