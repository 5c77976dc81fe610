// Reports a recording after its session.
#include "experiments/run/recorded.hpp"

#include <iostream>

#include "runtime/recording_file.hpp"

namespace darwinop::experiments {

bool reportRecording(const std::string& path) {
  if (path.empty()) return true;
  if (runtime::isCompleteRecording(path)) {
    std::cout << kRecorded << path << std::endl;
    return true;
  }
  std::cout << std::flush;
  std::cerr << kRecordedInPart << path << "; the cause is above. Make room, or choose another folder, and repeat it\n";
  return false;
}

}  // namespace darwinop::experiments
