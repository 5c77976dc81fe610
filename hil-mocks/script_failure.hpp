// What a scripted double does when a test departs from the script.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace darwinop::hil {

/// Gets a sentence. In a GoogleTest: [](const std::string& s) { ADD_FAILURE() << s; }.
using ScriptFailure = std::function<void(const std::string&)>;

/// The default: nothing that went wrong can go unseen.
inline void abortOnScriptFailure(const std::string& what) {
  std::fprintf(stderr, "script: %s\n", what.c_str());
  std::abort();
}

}  // namespace darwinop::hil
