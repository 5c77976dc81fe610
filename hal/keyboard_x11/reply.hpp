// Owner of an X server reply, which the caller must free.
#pragma once

#include <cstdlib>
#include <memory>

namespace darwinop::x11 {

struct Free {
  void operator()(void* reply) const { std::free(reply); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;

}  // namespace darwinop::x11
