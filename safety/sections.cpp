#include "safety/sections.hpp"

#include <stdexcept>

#include "core/joints.hpp"
#include "core/text/ini_text.hpp"
#include "core/text/letter_case.hpp"

namespace darwinop::safety {

bool isLimit(std::string_view key) {
  bool found = findJoint(jointName(key)).has_value();
  safety::Config{}.visit([&](std::string_view name, const auto&...) { found = found || name == text::lowered(key); });
  return found;
}

bool takeSafety(safety::Config& config, std::string_view section, std::string_view key, std::string_view value) {
  const std::string name = text::lowered(section);
  if (name == "safety")
    config.set("Safety", text::lowered(key), value);
  else if (name == "limits")
    config.set("Limits", jointName(key), value);
  else
    return false;
  return true;
}

void checkSafety(const safety::Config& config, const std::string& file) {
  try {
    config.check();
  } catch (const std::exception& wrong) {
    throw std::runtime_error(file + ", " + std::string{text::withoutFile(wrong.what())});
  }
}

}  // namespace darwinop::safety
