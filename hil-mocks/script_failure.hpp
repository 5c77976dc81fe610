// Failure callback of scripted test doubles.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace darwinop::hil {

/// Receives a message. In a GoogleTest: [](const std::string& s) { ADD_FAILURE() << s; }.
using ScriptFailure = std::function<void(const std::string&)>;

/// The default aborts, so that no failure goes unnoticed.
inline void abortOnScriptFailure(const std::string& what) {
  std::fprintf(stderr, "script: %s\n", what.c_str());
  std::abort();
}

}  // namespace darwinop::hil
