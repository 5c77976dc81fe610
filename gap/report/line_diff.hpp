// What changed between two texts, line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace darwinop::gap {

struct DiffLine {
  char kind = ' ';  // ' ' in both, '-' in the old one, '+' in the new one, '@' lines in both are left out here
  std::string text;
};

/// Lines that changed, with `context` lines around them. Empty: the texts are the same.
std::vector<DiffLine> lineDiff(std::string_view before, std::string_view after, std::size_t context = 2);

}  // namespace darwinop::gap
