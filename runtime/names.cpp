// Where the runtime's shared files are.
#include "runtime/names.hpp"

#include <cstdlib>

namespace darwinop::runtime {

RuntimeFiles::RuntimeFiles(const std::string& name) {
  const char* usual = std::getenv("DARWINOP_RUNTIME_NAME");
  exchange = name.empty() && usual != nullptr ? usual : name;
  if (exchange.empty()) exchange = "darwinop-runtime";
  if (exchange.find('/') == std::string::npos) exchange = "/dev/shm/" + exchange;
  loop_lock = exchange + ".loop";
  drive_lock = exchange + ".drive";
  pictures = exchange + ".pictures";
  pictures_asked = pictures + ".asked";
}

}  // namespace darwinop::runtime
