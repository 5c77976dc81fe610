// The next definition of an interposed function (C library or sanitizer).
#pragma once

#include <dlfcn.h>

#include <atomic>

namespace darwinop::hil::shim {

/// Resolved at the first call, possibly before our constructors have run: constant initialization only.
template <class Function>
class Next {
 public:
  constexpr explicit Next(const char* name) : name_{name} {}

  template <class... Arguments>
  auto operator()(Arguments... arguments) {
    Function* known = function_.load(std::memory_order_acquire);
    if (known == nullptr) {
      known = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
      function_.store(known, std::memory_order_release);  // concurrent look-ups give the same result
    }
    return known(arguments...);
  }

 private:
  const char* name_;
  std::atomic<Function*> function_{nullptr};
};

}  // namespace darwinop::hil::shim

#define DARWINOP_INTERPOSED extern "C" __attribute__((visibility("default")))
