// One bit in a small file that survives the process but not a reboot.
#pragma once

#include <string>

#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// For what the next loop must not miss: in doubt the bit is set. The file is created at once, so that in a sticky
/// folder such as /dev/shm no other user can take its name later. Makes system calls; not for the loop's thread.
class MarkerFile {
 public:
  /// Reads the file, or creates it with a cleared bit. Anything there that this user or root did not make as a plain
  /// file counts as set and is replaced: see warning(). Never blocks.
  explicit MarkerFile(std::string path);

  [[nodiscard]] bool isSet() const { return set_; }
  /// Writes only changes, and the file again if it is gone.
  void set(bool wanted);

  /// False: the name is taken and cannot be replaced, or the folder cannot be written. The bit is then lost with the
  /// process.
  [[nodiscard]] bool kept() const { return file_.fd() >= 0; }
  /// Sentence about what was found in the file's place, with path, owner and remedy; empty: nothing unexpected.
  [[nodiscard]] const std::string& warning() const { return warning_; }

  /// Removes the file if its bit is cleared.
  void removeIfClear();

 private:
  void find();
  void create();
  [[nodiscard]] bool write() const;

  std::string path_;
  Descriptor file_{-1};
  bool set_ = false;
  std::string warning_;
};

}  // namespace darwinop::runtime
