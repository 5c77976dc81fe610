// A text that a test breaks in one place.
#pragma once

#include <stdexcept>
#include <string>

namespace darwinop {

/// `text` with `by` in place of the first `what`. Throws std::logic_error if there is none: the test itself is wrong.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("the test's text has no " + what);
  return text.replace(at, what.size(), by);
}

}  // namespace darwinop
