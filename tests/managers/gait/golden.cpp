// Goals recorded from the reference, call by call: golden_gait.csv.
#include "managers/gait/golden.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace darwinop::gait {

std::vector<GoldenCall> goldenCalls() {
  std::ifstream file{DARWINOP_GOLDEN_GAIT};
  std::string line;
  if (!std::getline(file, line) || !line.starts_with("scenario,call,running_after,id01,"))
    throw std::runtime_error("no golden_gait.csv");
  std::vector<GoldenCall> calls;
  while (std::getline(file, line)) {
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream fields{line};
    GoldenCall call;
    fields >> call.scenario >> call.call >> call.running_after;
    for (int& tick : call.tick) fields >> tick;
    if (!fields) throw std::runtime_error("golden_gait.csv: " + line);
    calls.push_back(call);
  }
  return calls;
}

}  // namespace darwinop::gait
