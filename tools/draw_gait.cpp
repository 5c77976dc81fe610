// Prints a picture of docs/gait.md, drawn from the engine itself: `draw_gait period|amplitudes|dsp_ratio|posture`.
#include <iostream>
#include <string_view>

#include "gait_in_time.hpp"
#include "gait_poses.hpp"

int main(int argc, char** argv) {
  using namespace darwinop::pictures;
  const std::string_view name = argc == 2 ? argv[1] : "";
  for (const auto& [known, draw] : {std::pair{"period", &period},
                                    {"amplitudes", &amplitudes},
                                    {"dsp_ratio", &doubleSupport},
                                    {"posture", &posture}})
    if (name == known) {
      std::cout << draw();
      return 0;
    }
  std::cerr << "usage: " << argv[0] << " period|amplitudes|dsp_ratio|posture\n";
  return 2;
}
