// Paths of the runtime's shared files.
#include "runtime/names.hpp"

#include <cstdlib>
#include <string_view>

namespace darwinop::runtime {

bool startedUnattended() {
  const char* const value = std::getenv(kUnattended);
  return value != nullptr && std::string_view{value} == "1";
}

RuntimeFiles::RuntimeFiles(const std::string& name) {
  const char* usual = std::getenv("DARWINOP_RUNTIME_NAME");
  exchange = name.empty() && usual != nullptr ? usual : name;
  if (exchange.empty()) exchange = "darwinop-runtime";
  if (exchange.find('/') == std::string::npos) exchange = "/dev/shm/" + exchange;
  commands = exchange + ".commands";
  loop_lock = exchange + ".loop";
  drive_lock = exchange + ".drive";
  released = exchange + ".released";
  held = exchange + ".held";
  pictures = exchange + ".pictures";
  pictures_asked = pictures + ".asked";
}

}  // namespace darwinop::runtime
