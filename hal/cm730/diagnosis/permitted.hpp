// Hardware that robot.ini permits, beside what is driven without a setting.
#pragma once

#include <cstdint>

#include "core/registers.hpp"
#include "core/servo_models.hpp"

namespace darwinop::cm730 {

struct Permitted {
  std::uint16_t board_model = find(kCm730, "model").reset;
  bool no_board = false;  // servos alone on an adapter; a board that answers all the same is refused
  ServoModels servo_models{};
};

}  // namespace darwinop::cm730
