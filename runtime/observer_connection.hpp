// Shared file by which `darwinop run` observes a controller that hosts the loop itself.
#pragma once

#include <string>

namespace darwinop::runtime {

/// The file has the loop's statistics and survives a kill -9 of the controller. Its folder is private and has a name
/// that no other user can take beforehand.
class ObserverConnection {
 public:
  /// Creates the folder, and removes what earlier runs of this user left when they were killed.
  ObserverConnection();
  ~ObserverConnection();
  ObserverConnection(const ObserverConnection&) = delete;
  ObserverConnection& operator=(const ObserverConnection&) = delete;

  /// For DARWINOP_EXCHANGE. Empty: no folder could be created, and the controller uses private memory.
  [[nodiscard]] std::string path() const { return folder_.empty() ? "" : folder_ + "/exchange"; }

 private:
  std::string folder_;
};

}  // namespace darwinop::runtime
