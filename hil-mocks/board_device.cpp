// The CM-730's own registers.
#include <algorithm>
#include <array>
#include <cmath>

#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {
namespace {

// In the order x, y, z.
constexpr std::array<const Register*, 3> kGyro{&find(kCm730, "gyro_x"), &find(kCm730, "gyro_y"),
                                               &find(kCm730, "gyro_z")};
constexpr std::array<const Register*, 3> kAccel{&find(kCm730, "accel_x"), &find(kCm730, "accel_y"),
                                                &find(kCm730, "accel_z")};

std::uint16_t countsOf(const Register& r, double si) {
  const double raw = std::nearbyint(si / r.scale + r.zero);
  return static_cast<std::uint16_t>(std::clamp(raw, double{0}, static_cast<double>(r.high)));
}

constexpr std::uint8_t kSupply = find(kCm730, "voltage").address;
constexpr std::uint8_t kButtons = find(kCm730, "buttons").address;

}  // namespace

BoardDevice::BoardDevice(std::uint16_t model, std::uint8_t firmware) : BusDevice{kBoardLayout} {
  table_.setWord(find(kCm730, "model").address, model);
  table_.setByte(board::kFirmware, firmware);
}

void BoardDevice::measure(const BodyState& body, double supply_v) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table_.setWord(kGyro[axis]->address, countsOf(*kGyro[axis], body.gyro_rad_s[axis]));
    table_.setWord(kAccel[axis]->address, countsOf(*kAccel[axis], body.accel_m_s2[axis]));
  }
  table_.setByte(kButtons, body.buttons);
  table_.setByte(kSupply, static_cast<std::uint8_t>(std::clamp(std::nearbyint(supply_v * 10), 0.0, 255.0)));
}

void BoardDevice::restart() {
  table_.reset(Memory::kRam);
  forgetRegistered();
}

}  // namespace darwinop::hil
