// Sets and restores environment variables.
#include "window/scoped_environment.hpp"

#include <stdlib.h>

namespace darwinop::window {

ScopedEnvironment::ScopedEnvironment(const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t sign = setting.find('=');
    const std::string name = setting.substr(0, sign);
    const char* const value = getenv(name.c_str());
    before_.emplace_back(name, value == nullptr ? std::nullopt : std::optional<std::string>{value});
    setenv(name.c_str(), setting.substr(sign + 1).c_str(), 1);
  }
}

ScopedEnvironment::~ScopedEnvironment() {
  for (const auto& [name, value] : before_) {
    if (value)
      setenv(name.c_str(), value->c_str(), 1);
    else
      unsetenv(name.c_str());
  }
}

}  // namespace darwinop::window
