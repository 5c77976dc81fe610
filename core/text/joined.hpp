// Puts words into one text.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// "a, b, c". `words`: any range of strings.
template <class Words>
std::string joined(const Words& words, std::string_view between = ", ") {
  std::string text;
  bool is_first = true;
  for (const auto& word : words) {
    if (!is_first) text += between;
    text += word;
    is_first = false;
  }
  return text;
}

}  // namespace darwinop::text
