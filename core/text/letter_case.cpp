#include "core/text/letter_case.hpp"

#include <algorithm>
#include <cctype>

namespace darwinop::text {

std::string lowered(std::string_view text) {
  std::string out{text};
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace darwinop::text
