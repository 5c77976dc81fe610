// Temporary folder of one window. The folder of a killed window is removed by the next one.
#pragma once

#include <string>

namespace darwinop::window {

class PrivateFolder {
 public:
  /// In shared memory, like all files of the runtime: the loop must not wait for a disk. Throws std::runtime_error.
  explicit PrivateFolder(const std::string& parent = "/dev/shm");
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace darwinop::window
