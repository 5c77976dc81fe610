// Another darwinop program, which ends with this one.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace darwinop::window {

class Child {
 public:
  /// kBehind: what it prints is dropped, its complaints are kept. kTerminal: it talks with who started this program.
  enum class Place { kBehind, kTerminal };

  /// `noun`: "runtime" starts darwinop-runtime, which lies beside this program. `grace`: how long it may take to end.
  /// Throws std::runtime_error.
  Child(const std::string& noun, const std::vector<std::string>& arguments, std::chrono::milliseconds grace,
        Place place = Place::kBehind);
  /// Asks it to end, waits, and kills it when it does not.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Its exit status as a shell has it; nothing: it still runs.
  std::optional<int> ended();
  [[nodiscard]] const std::string& noun() const { return noun_; }

 private:
  std::string noun_;
  std::chrono::milliseconds grace_;
  pid_t pid_ = 0;
  std::optional<int> status_;
};

}  // namespace darwinop::window
