// Version of the runtime. The build defines both macros for this file only.
#include "runtime/version.hpp"

#ifndef DARWINOP_VERSION
#define DARWINOP_VERSION "unknown"
#endif
#ifndef DARWINOP_COMMIT
#define DARWINOP_COMMIT ""
#endif

namespace darwinop::runtime {

std::string version() {
  const std::string commit = DARWINOP_COMMIT;
  return commit.empty() ? DARWINOP_VERSION : std::string{DARWINOP_VERSION} + " (" + commit + ")";
}

}  // namespace darwinop::runtime
