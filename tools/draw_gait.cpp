// Draws the pictures of docs/gait.md from the engine itself: `draw_gait FOLDER`; with `--check FOLDER` checks whether
// the pictures there are still what it draws.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "gait_in_time.hpp"
#include "gait_poses.hpp"

namespace {

using namespace darwinop::pictures;

std::string contents(const std::filesystem::path& file) {
  std::ifstream in{file};
  return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

int main(int argc, char** argv) {
  const bool check = argc == 3 && std::string{argv[1]} == "--check";
  if (argc != 2 && !check) {
    std::cerr << "usage: " << argv[0] << " [--check] FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder{argv[argc - 1]};
  int wrong = 0;
  for (const auto& [name, drawn] : {std::pair{"period.svg", period()},
                                    {"amplitudes.svg", amplitudes()},
                                    {"dsp_ratio.svg", doubleSupport()},
                                    {"posture.svg", posture()}}) {
    if (!check)
      std::ofstream{folder / name} << drawn;
    else if (contents(folder / name) != drawn)
      std::cerr << folder / name << " is not what the engine does; renew it with ./dev docs\n", wrong = 1;
  }
  return wrong;
}
