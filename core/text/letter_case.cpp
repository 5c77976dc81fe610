#include "core/text/letter_case.hpp"

#include <algorithm>
#include <cctype>

#include "core/joints.hpp"

namespace darwinop::text {

std::string lowered(std::string_view text) {
  std::string out{text};
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string_view jointName(std::string_view key) {
  for (const JointRow& joint : kJointTable)
    if (lowered(joint.name) == lowered(key)) return joint.name;
  return key;
}

}  // namespace darwinop::text
