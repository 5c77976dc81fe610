// Model file texts for tests.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// Error message of `action`; empty if it succeeds.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& wrong) {
    return wrong.what();
  }
  return {};
}

inline const std::string kNamed = "[model]\nname = test\n";  // the minimal model file; two lines

/// Error message for a file with these lines, from line 3 on.
inline std::string refusalOf(const std::string& lines) {
  return refusal([&] { parseModel(kNamed + lines, "my.ini"); });
}

inline Model modelOf(const std::string& lines) {
  return parseModel(kNamed + lines, "my.ini");
}

}  // namespace darwinop::twin
