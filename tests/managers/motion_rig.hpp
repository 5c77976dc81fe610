// Test fixture: a motion file with two pages, and a simulated robot with all joints at 2000 ticks.
#pragma once

#include <DARwInOPMotionManager.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "managers/motion/pages.hpp"
#include "support/temporary_folder.hpp"
#include "webots/fixture.hpp"

namespace darwinop::webots_api {

class MotionManagerTest : public Facade {
 protected:
  MotionManagerTest() {
    for (JointSensors& joint : fake.image.joint) joint.position = joint.commanded = radFromTicks(2000);
    pages_[1] = motion::pageOf({motion::stepTo(2100, 10)});  // 13 ticks
    pages_[2] = motion::pageOf({motion::stepTo(2100, 13)});  // 16 ticks
    pages_[2].slopes[3] = 0x77;
    write();
    robot();
    fake.published.clear();
  }
  void write() {
    const auto bytes = motion::encodePages(pages_);
    std::ofstream{path_, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                 static_cast<std::streamsize>(bytes.size()));
  }
  const JointCommand& last(Joint joint) { return fake.last().joint[index(joint)]; }
  /// Goals of the neck in ticks, one per published image.
  std::vector<int> necks() {
    std::vector<int> seen;
    for (const Commands& image : fake.published) {
      const JointCommand& neck = image.joint[index(Joint::kNeck)];
      seen.push_back(neck.has(JointCommand::kGoal) ? ticksFromRad(neck.goal) : -1);
    }
    return seen;
  }
  int ticksOf(Joint joint) { return ticksFromRad(last(joint).goal); }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "pages.bin";
  motion::PageFile pages_ = motion::emptyFile();
};

}  // namespace darwinop::webots_api
