// Python controllers: finds an interpreter of the version that the modules were built for.
#include "runtime/python_command.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "hal/process/child_process.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {

namespace {

constexpr const char* kProgramVariable = "DARWINOP_PYTHON_PROGRAM";

/// "3.11" from the name of the extension, _darwinop.cpython-311-x86_64-linux-gnu.so; empty: there is no extension.
std::string versionOf(const std::string& modules) {
  constexpr std::string_view kStart = "_darwinop.cpython-3";
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator{modules, unreadable}) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(kStart)) continue;
    const std::size_t end = name.find_first_not_of("0123456789", kStart.size());
    return "3." + name.substr(kStart.size(), end - kStart.size());
  }
  return "";
}

bool loadsModules(const std::string& python, const std::string& modules) {
  using process::Stream;
  try {
    return process::ChildProcess{{.command = {python, "-c", "import _darwinop"},
                                  .streams = {Stream::nothing(), Stream::nothing(), Stream::nothing()},
                                  .environment = {pythonPath(modules)}}}
        .wait()
        .isNormal();
  } catch (const std::system_error&) {
    return false;  // there is no such program
  }
}

}  // namespace

bool isPythonScript(const std::string& path) {
  return path.ends_with(kPythonSuffix);
}

std::string findPython(const std::string& modules) {
  const std::string version = versionOf(modules);
  if (version.empty())
    throw std::runtime_error(messages::kNoPythonModules + modules +
                             "/_darwinop.cpython-*.so; install pybind11-dev and python3-dev, and build again");
  std::vector<std::string> programs{"python3", "python" + version, "/usr/bin/python" + version};
  if (const char* const chosen = std::getenv(kProgramVariable); chosen != nullptr && *chosen != '\0')
    programs = {chosen};
  std::string tried;
  for (const std::string& program : programs) {
    if (loadsModules(program, modules)) return program;
    tried += (tried.empty() ? "" : ", ") + program;
  }
  throw std::runtime_error(messages::kNoPython + modules + ", which need Python " + version + " (tried: " + tried +
                           "); install it, or name one with " + kProgramVariable);
}

std::string pythonPath(const std::string& modules) {
  const char* const others = std::getenv("PYTHONPATH");
  return "PYTHONPATH=" + modules + (others != nullptr && *others != '\0' ? ":" + std::string{others} : "");
}

}  // namespace darwinop::runtime
