// A folder for the files of one window, removed with it; one of a window that was killed is removed by the next window.
#pragma once

#include <string>

namespace darwinop::window {

class PrivateFolder {
 public:
  /// In memory, as all of the runtime's files: the loop must not wait for a disk. Throws std::runtime_error.
  explicit PrivateFolder(const std::string& parent = "/dev/shm");
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace darwinop::window
