// A file descriptor that is closed at the end of its scope.
#pragma once

#include <unistd.h>

namespace darwinop {

struct Descriptor {
  int number;  // negative: none
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

}  // namespace darwinop
