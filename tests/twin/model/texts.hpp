// Model files for tests.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// The sentence with which `action` refuses; empty: it did not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& wrong) {
    return wrong.what();
  }
  return {};
}

inline const std::string kNamed = "[model]\nname = test\n";  // the least that a model file has; two lines

/// The refusal of a file that has these lines, from line 3 on.
inline std::string refusalOf(const std::string& lines) {
  return refusal([&] { parseModel(kNamed + lines, "my.ini"); });
}

inline Model modelOf(const std::string& lines) {
  return parseModel(kNamed + lines, "my.ini");
}

}  // namespace darwinop::twin
