// What a child process is started with.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hal/process/account.hpp"

namespace darwinop::process {

/// What one of its descriptors 0, 1, 2 ... refers to.
struct Stream {
  enum class Kind {
    kInherited,
    kNothing,     // /dev/null
    kPipe,        // 0: we write and it reads; others: it writes and we read
    kDescriptor,  // a copy of ours
    kAppended,    // appended to a file, created with mode 0644, never through a symbolic link
  };
  Kind kind = Kind::kInherited;
  int descriptor = -1;
  std::string path = {};

  static Stream nothing() { return {Kind::kNothing}; }
  static Stream pipe() { return {Kind::kPipe}; }
  static Stream copyOf(int descriptor) { return {Kind::kDescriptor, descriptor}; }
  /// Opened with our rights, even if the program runs as another user.
  static Stream appendedTo(std::string path) { return {Kind::kAppended, -1, std::move(path)}; }
};

struct Start {
  static constexpr std::size_t kMaxStreams = 4;

  /// Which signals it gets with us: Ctrl-C in a terminal reaches the whole group.
  enum class Group {
    kOurs,
    kItsOwn,
    kItsOwnSession,  // without our terminal: cannot ask questions there
  };

  std::vector<std::string> command;           // no shell; a first word without '/' is searched in PATH
  std::string name = {};                      // argv[0]; empty: the first word
  std::vector<Stream> streams = {};           // of descriptors 0, 1, 2 ...; missing ones are inherited
  bool closes_others = false;                 // inherits only `streams` and 0 to 2, whether or not ours have O_CLOEXEC
  std::string folder = {};                    // working directory; empty: ours
  std::vector<std::string> environment = {};  // "NAME=value", added to ours
  std::string without_variable = {};          // a name of our environment
  char* secret = nullptr;  // "NAME=value" for its environment; never copied, so that the caller can wipe it
  Group group = Group::kOurs;
  bool ends_with_us = false;  // gets SIGTERM when the thread that started it ends, even by kill -9
  /// End signals (hal/signals.hpp) that we ignore stay ignored, such as SIGHUP under nohup. All others have their
  /// defaults, and no signal is blocked.
  bool keeps_ignored_signals = false;

  /// Set: it is forked, and the constructor does not wait for exec. A program that cannot be executed ends with code
  /// 126 or 127 after "<prefix>cannot run NAME: reason" on its standard error. Required by the fields below.
  std::optional<std::string> error_prefix = {};
  std::optional<Account> account = {};  // to run as, with its HOME, USER and LOGNAME
  bool ordinary_priority = false;       // not our real-time priority
  bool expendable = false;              // not our protection from the kernel's OOM killer
};

/// Path of a program: unchanged with '/', else from PATH; empty: not installed.
std::string findProgram(const std::string& name);

/// Path of NAME beside the running program, whether or not it exists.
std::string programBeside(const std::string& name);

}  // namespace darwinop::process
