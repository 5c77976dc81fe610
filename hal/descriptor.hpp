// A file descriptor that is closed at the end of its scope.
#pragma once

#include <unistd.h>

namespace darwinop {

struct Descriptor {
  explicit Descriptor(int opened) : number{opened} {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }

  int number;  // negative: none
};

}  // namespace darwinop
