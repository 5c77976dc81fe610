// Python controllers: the interpreter that `darwinop run` starts, and what it is started with.
#pragma once

#include <string>

namespace darwinop::runtime {

inline constexpr const char* kPythonSuffix = ".py";

bool isPythonScript(const std::string& path);

/// The first interpreter that loads the modules in this folder, which are built for one version of Python: that of
/// DARWINOP_PYTHON_PROGRAM if it is set; else python3 of PATH, that version in PATH, or Debian's. Runs each, 20 ms.
/// Throws std::runtime_error with what was tried.
std::string findPython(const std::string& modules);

/// "PYTHONPATH=" with this folder before those of ours.
std::string pythonPath(const std::string& modules);

}  // namespace darwinop::runtime
