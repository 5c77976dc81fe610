// Log of the supervisor.
#include "supervisor/journal.hpp"

#include <time.h>
#include <unistd.h>

#include "hal/diagnostics.hpp"

namespace darwinop::supervisor {

void log(const std::string& text) {
  const time_t now = time(nullptr);
  tm parts{};
  char stamp[32] = "";
  if (localtime_r(&now, &parts) != nullptr) strftime(stamp, sizeof stamp, "%Y-%m-%d %H:%M:%S", &parts);
  // One write(): the runtime writes to the same file.
  const std::string line = std::string{stamp} + " darwinop supervisor: " + text + "\n";
  (void)writeWithoutWaiting(STDERR_FILENO, line);
}

}  // namespace darwinop::supervisor
