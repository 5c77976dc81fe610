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

GuardedMapping mapped(const SharedFile& file, const std::string& path, std::size_t size, int protection);

/// A file under construction: created under another name, so that no process maps an incomplete block.
class FreshFile {
 public:
  FreshFile(std::string path, mode_t mode, gid_t group, std::size_t size);
  ~FreshFile();
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;

  [[nodiscard]] const SharedFile& file() const { return file_; }
  /// Replaces a file of that name. Processes that map the old file keep it.
  SharedFile place();

 private:
  /// Under a name that no other user can take beforehand; with mode 0600.
  static SharedFile opened(std::string& fresh);

  std::string path_, fresh_;
  SharedFile file_;
  bool placed_ = false;
};

/// The runtime's output, for reading.
SharedFile openedBlock(const std::string& path);
/// The runtime's input. `user`: the owner of its output.
SharedFile openedCommands(const std::string& path, uid_t user);

bool hasSize(const SharedFile& file, std::size_t size);
uid_t userOf(const SharedFile& file);

}  // namespace darwinop::runtime
