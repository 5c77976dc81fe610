// The function behind the one that we stand before: that of the C library, or of a sanitizer.
#pragma once

#include <dlfcn.h>

#include <atomic>

namespace darwinop::hil::shim {

/// Looked up at the first call, which may come before any constructor of ours has run: constant initialisation only.
template <class Function>
class Next {
 public:
  constexpr explicit Next(const char* name) : name_{name} {}

  template <class... Arguments>
  auto operator()(Arguments... arguments) {
    Function* known = function_.load(std::memory_order_acquire);
    if (known == nullptr) {
      known = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
      function_.store(known, std::memory_order_release);  // two threads find the same
    }
    return known(arguments...);
  }

 private:
  const char* name_;
  std::atomic<Function*> function_{nullptr};
};

}  // namespace darwinop::hil::shim

#define DARWINOP_INTERPOSED extern "C" __attribute__((visibility("default")))
