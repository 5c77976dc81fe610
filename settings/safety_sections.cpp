#include "settings/safety_sections.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace darwinop::settings {

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

bool isLimit(std::string_view key) {
  bool found = findJoint(jointName(key)).has_value();
  safety::Config{}.visit([&](std::string_view name, const auto&...) { found = found || name == lowered(key); });
  return found;
}

bool takeSafety(safety::Config& config, std::string_view section, std::string_view key, std::string_view value) {
  const std::string room = lowered(section);
  if (room == "safety")
    config.set("Safety", lowered(key), value);
  else if (room == "limits")
    config.set("Limits", jointName(key), value);
  else
    return false;
  return true;
}

void checkSafety(const safety::Config& config, const std::string& file) {
  try {
    config.check();
  } catch (const std::exception& wrong) {
    throw std::runtime_error(file + ", " + std::string{withoutFile(wrong.what())});
  }
}

std::string_view withoutFile(std::string_view sentence) {
  constexpr std::string_view kFile = "config.ini, ";
  if (sentence.starts_with(kFile)) sentence.remove_prefix(kFile.size());
  return sentence;
}

}  // namespace darwinop::settings
