// Arbitrary bytes to the virtual board: no crash, no hang.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "hil-mocks/virtual_robot.hpp"

namespace {

/// After a pause a ping of the board must work again; its id may have changed.
void mustStillAnswer(darwinop::hil::VirtualRobot& robot) {
  using namespace darwinop;
  robot.advance(robot.now() + std::chrono::seconds{2});
  while (!robot.output().empty()) robot.output().pop();
  std::array<std::uint8_t, 8> ping;
  robot.receive(encodePing(ping, robot.board().device().id()), robot.now());
  robot.advance(robot.now() + std::chrono::milliseconds{10});
  if (robot.output().empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace darwinop::hil;
  BoardOptions options;
  options.servo_power = true;
  options.body_step = std::chrono::milliseconds{100};  // motion is not the point here
  VirtualRobot robot{options};
  // The first byte of each piece: length, pause after it, and whether the rest is id, instruction and parameters
  // of a sound frame (a checksum is hard to guess) or bytes as they come.
  while (size > 1) {
    const std::size_t length = std::min<std::size_t>(1 + data[0] % 32, size - 1);
    const darwinop::Bytes piece{data + 1, length};
    if (data[0] >= 128 && length >= 2) {
      std::array<std::uint8_t, darwinop::kMaxFrame> frame;
      const auto instruction = static_cast<darwinop::Instruction>(piece[1]);
      robot.receive(encodeInstruction(frame, piece[0], instruction, piece.subspan(2)), robot.now());
    } else {
      robot.receive(piece, robot.now());
    }
    robot.advance(robot.now() + std::chrono::milliseconds{data[0] / 8 % 16});
    data += 1 + length;
    size -= 1 + length;
  }
  mustStillAnswer(robot);
  return 0;
}
