#include "gap/case/joint_columns.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/text/joined.hpp"
#include "experiments/logs/units.hpp"
#include "gap/case/case.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr std::array<std::string_view, 7> kQuantities{"goal", "pos", "speed", "load", "volt", "temp", "current"};

struct JointColumn {
  std::string_view quantity, joint, rest;  // "goal", "Wrist_Pitch", "_rad"; without a joint: of all joints
};

/// Nothing: the column is not a quantity of a servo.
std::optional<JointColumn> parsed(std::string_view name) {
  const std::string_view quantity = name.substr(0, name.find('_'));
  if (std::ranges::find(kQuantities, quantity) == kQuantities.end()) return std::nullopt;
  std::string_view bare = logs::withoutSuffix(name);
  if (bare == name && name.ends_with("_raw")) bare = name.substr(0, name.size() - 4);
  const std::string_view joint = bare.size() > quantity.size() ? bare.substr(quantity.size() + 1) : "";
  return JointColumn{quantity, joint, name.substr(bare.size())};
}

/// The joint is there, and what follows its name is not a unit: "speed_Elbow_50steps_s".
bool isInUnknownUnit(const JointColumn& column, std::string_view joint) {
  return column.joint.size() > joint.size() && column.joint.starts_with(joint) && column.joint[joint.size()] == '_' &&
         column.quantity != "goal" && column.quantity != "pos";
}

std::string jointsOf(const logs::Log& log) {
  std::vector<std::string> joints;
  for (const logs::Column& column : log.columns)
    if (const auto found = parsed(column.name); found && found->quantity == "goal" && !found->joint.empty())
      joints.emplace_back(found->joint);
  return joints.empty() ? "none" : text::joined(joints, ", ");
}

}  // namespace

logs::Log columnsOfJoint(logs::Log log, std::string_view joint, std::vector<std::string>& notes) {
  const std::string time = log.columns[log.time].name;
  std::vector<logs::Column> kept;
  bool goal = false;
  for (logs::Column& column : log.columns) {
    const std::optional<JointColumn> found = parsed(column.name);
    if (!found || found->joint.empty()) {
      kept.push_back(std::move(column));
    } else if (found->joint == joint) {
      goal = goal || found->quantity == "goal";
      column.name = std::string{found->quantity} + std::string{found->rest};
      std::erase_if(kept, [&](const logs::Column& shared) { return shared.name == column.name; });
      kept.push_back(std::move(column));
    } else if (isInUnknownUnit(*found, joint)) {
      const std::string note = "column " + column.name + " " + messages::kUnitLeftOut;
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
  }
  if (!goal)
    throw BadInput(log.file + ": " + messages::kNoGoalOfJoint + std::string{joint} + "; the log has goals of " +
                   jointsOf(log));
  log.columns = std::move(kept);
  log.time = static_cast<std::size_t>(std::ranges::find(log.columns, time, &logs::Column::name) - log.columns.begin());
  return log;
}

logs::Log withTorque(logs::Log log, double on) {
  if (log.find("torque_on") == nullptr) log.columns.push_back({"torque_on", "", std::vector<double>(log.rows(), on)});
  return log;
}

}  // namespace darwinop::gap
