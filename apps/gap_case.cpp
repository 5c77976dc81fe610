// Makes a case from recordings of the robot.
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "gap/robot/joint_case.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {
namespace {

Joint jointCalled(const std::string& name) {
  const auto row = std::ranges::find(kJointTable, name, &JointRow::name);
  if (row == kJointTable.end())
    throw std::runtime_error("unknown joint '" + name + "'; see docs/logs.md for the names, for example ShoulderR");
  return static_cast<Joint>(row - kJointTable.begin());
}

}  // namespace

int makeCase(const Arguments& given) {
  JointCaseRequest request;
  if (!given.model.empty()) request.model = given.model;
  request.joint = jointCalled(given.joint);
  request.recordings = given.recordings;
  request.kept = given.kept;
  for (const std::string& sentence : writeJointCase(request, given.out)) std::cout << sentence << '\n';
  std::cerr << "darwinop gap: " << given.out << ": case created; analyse it with: darwinop gap run " << given.out
            << "\n";
  return 0;
}

}  // namespace darwinop::gap
