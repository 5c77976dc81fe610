// Files of the exchange: creates them complete, opens and maps those of another process. Errors are std::runtime_error
// with a message for the user.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

#include "hal/guarded_mapping.hpp"
#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// Of the commands that belong to the exchange `path`.
std::string commandsPath(const std::string& path);

GuardedMapping mapped(const Descriptor& file, const std::string& path, std::size_t size, int protection);

/// A file under construction: created under another name, so that no process maps an incomplete block.
class FreshFile {
 public:
  FreshFile(std::string path, mode_t mode, gid_t group, std::size_t size);
  ~FreshFile();
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;

  [[nodiscard]] const Descriptor& file() const { return file_; }
  /// Replaces a file of that name. Processes that map the old file keep it.
  Descriptor place();

 private:
  /// Under a name that no other user can take beforehand; with mode 0600.
  static Descriptor opened(std::string& fresh);

  std::string path_, fresh_;
  Descriptor file_;
  bool placed_ = false;
};

/// The runtime's output, for reading.
Descriptor openedBlock(const std::string& path);
/// The runtime's input. `user`: the owner of its output.
Descriptor openedCommands(const std::string& path, uid_t user);

bool hasSize(const Descriptor& file, std::size_t size);
uid_t userOf(const Descriptor& file);

}  // namespace darwinop::runtime
