// webots::LED.
#include "webots/LED.hpp"

#include "core/counts.hpp"
#include "webots/Node.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

namespace webots_api = darwinop::webots_api;

LED::LED(const std::string& name, webots_api::RobotImpl& robot, Which which, int panel_bit)
    : Device(name, Node::LED, robot), which_(which), panel_bit_(panel_bit), value_(0), set_(false) {}

LED::~LED() = default;

void LED::set(int value) {
  darwinop::LedCommand& led = robot_.led();
  value_ = which_ == BACK ? (value != 0 ? 1 : 0) : value & 0xFFFFFF;
  set_ = true;
  if (which_ == EYE) return led.setEye(darwinop::rgb15From24(value_));
  if (which_ == HEAD) return led.setHead(darwinop::rgb15From24(value_));
  // The three back LEDs share one register: the others keep their requested state, or the one that the board reports.
  const int others = led.has(darwinop::LedCommand::kPanel) ? led.panel : robot_.session().sensors().board.led_panel;
  led.setPanel(static_cast<std::uint8_t>(value_ != 0 ? others | panel_bit_ : others & ~panel_bit_));
}

int LED::get() const {
  if (set_) return value_;
  const darwinop::BoardSensors& board = robot_.session().sensors().board;
  if (which_ == EYE) return darwinop::rgb24From15(board.led_eye);
  if (which_ == HEAD) return darwinop::rgb24From15(board.led_head);
  return (board.led_panel & panel_bit_) != 0 ? 1 : 0;
}

}  // namespace webots
