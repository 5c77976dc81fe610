// Another darwinop program, which ends with this one.
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace darwinop::window {

class Child {
 public:
  /// kBehind: what it prints is dropped, its complaints are kept. kTerminal: it talks with who started this program.
  /// kHeard: all that it says comes here; it has no terminal to ask on.
  enum class Place { kBehind, kTerminal, kHeard };
  /// File descriptors 1, 2 and 3 of one that is heard; on the last one programs tell programs.
  static constexpr std::size_t kStreams = 3;

  /// `noun`: "runtime" starts darwinop-runtime, which lies beside this program. `grace`: how long it may take to end.
  /// Throws std::runtime_error.
  Child(const std::string& noun, const std::vector<std::string>& arguments, std::chrono::milliseconds grace,
        Place place = Place::kBehind)
      : Child{noun, programOf(noun), arguments, grace, place, nullptr} {}
  /// `variable`: "NAME=value" for its environment alone; null: none. DARWINOP_PASSWORD of ours is never handed on.
  Child(std::string noun, const std::string& program, const std::vector<std::string>& arguments,
        std::chrono::milliseconds grace, Place place, char* variable);
  /// Asks it to end, waits, and kills it when it does not. One that is heard is asked as by Ctrl-C, with all its own.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// As Ctrl-C in a terminal: it and what it has started.
  void interrupt();
  /// To read what it says, without waiting; -1: it is not heard.
  [[nodiscard]] int stream(std::size_t number) const { return streams_.at(number); }
  /// Its exit status as a shell has it; nothing: it still runs.
  std::optional<int> ended();
  [[nodiscard]] const std::string& noun() const { return noun_; }

  /// Path of the program beside this one, be it there or not.
  [[nodiscard]] static std::string programOf(const std::string& noun);

 private:
  void tell(int signal) const;
  bool endsWithin(std::chrono::milliseconds time);

  std::string noun_;
  std::chrono::milliseconds grace_;
  Place place_;
  pid_t pid_ = 0;
  std::array<int, kStreams> streams_{-1, -1, -1};
  std::optional<int> status_;
};

}  // namespace darwinop::window
