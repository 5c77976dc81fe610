// Recordings of the robot as a case.
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "gap/case/robot/joint_case.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {
namespace {

Joint jointCalled(const std::string& name) {
  const auto row = std::ranges::find(kJointTable, name, &JointRow::name);
  if (row == kJointTable.end())
    throw std::runtime_error("there is no joint '" + name + "'; docs/logs.md has their names, such as ShoulderR");
  return static_cast<Joint>(row - kJointTable.begin());
}

}  // namespace

int makeCase(const Arguments& given) {
  JointCaseRequest request;
  if (!given.model.empty()) request.model = given.model;
  request.joint = jointCalled(given.joint);
  request.recordings = given.recordings;
  request.held_out = given.held_out;
  for (const std::string& sentence : writeJointCase(request, given.out)) std::cout << sentence << '\n';
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << "\n";
  return 0;
}

}  // namespace darwinop::gap
