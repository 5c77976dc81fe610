// Sets an environment variable for the length of a test.
#pragma once

#include <stdlib.h>

#include <string>

namespace darwinop::runtime {

class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_{name} { setenv(name, value.c_str(), 1); }
  ~Environment() { unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

}  // namespace darwinop::runtime
