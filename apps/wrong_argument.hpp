// Arguments that their parser accepts and the program cannot use: the exit code is that of other wrong arguments.
#pragma once

#include <exception>
#include <stdexcept>

#include "exit_codes.hpp"

namespace darwinop::app {

class WrongArgument : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Result of `read`, which reads arguments and opens nothing; its errors become WrongArgument.
template <class Read>
auto fromArguments(const Read& read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    throw WrongArgument(error.what());
  }
}

/// Of a program that ends with this error.
inline int exitCodeOf(const std::exception& error) {
  return dynamic_cast<const WrongArgument*>(&error) != nullptr ? kWrong : kFailed;
}

}  // namespace darwinop::app
