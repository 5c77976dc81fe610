// webots::Device: base class of the devices.
#include "webots/Device.hpp"

#include "webots/robot_impl.hpp"

namespace webots {

Device::Device(const std::string& name, int node_type, darwinop::webots_api::RobotImpl& robot)
    : robot_(robot), name_(name), node_type_(node_type), tag_(robot.nextTag()) {}

void Device::refresh() {}

std::string Device::getModel() const {
  return {};
}

}  // namespace webots
