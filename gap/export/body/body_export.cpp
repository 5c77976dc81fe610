#include "gap/export/body/body_export.hpp"

#include "gap/export/body/body_holds.hpp"
#include "gap/export/body/body_texts.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "twin/body/joint_torques.hpp"

namespace darwinop::gap {

twin::LinkInertia BodyText::link(std::size_t link) const {
  return twin::inertiaOfLink(body, link == twin::kTrunkLink ? map.trunk : map.link[link]);
}

std::array<double, 4> BodyText::atZero(std::size_t joint) const {
  // A hinge of MuJoCo turns its link by q - qpos0.
  std::array<double, 4> back{}, out{};
  mju_axisAngle2Quat(back.data(), body.jnt_axis + 3 * body.dof_jntid[map.dof[joint]], -body.qpos0[map.qpos[joint]]);
  mju_mulQuat(out.data(), body.body_quat + 4 * map.link[joint], back.data());
  return out;
}

std::string threeNumbers(const double* values) {
  return shortest(values[0]) + " " + shortest(values[1]) + " " + shortest(values[2]);
}

Export exportBody(Target target, const twin::Model& model, const ExportSettings& settings) {
  checkSettings(target, settings);
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  BodyText of{model, settings, *compiled, twin::mapBody(*compiled, model.body.xml), {}};
  BodyCase robot;
  robot.joints.model = model;
  const Hypothesis all = bodyBaselineOf(robot);
  std::vector<twin::Servo> servos;
  for (std::size_t i = 0; i < kJoints; ++i) {
    servos.emplace_back(model.servo, twin::effectsOf(model, static_cast<Joint>(i)));
    of.servos.push_back(numbersOf(atJoint(all, static_cast<Joint>(i)), settings.conditions()));
  }
  const twin::JointTorques loads{*compiled, of.map, servos, false};  // effects that change masses and zeros of joints

  Export out;
  addBodyLosses(target, model, out);
  std::vector<std::string> comments{
      "Robot " + settings.model + ", written by darwinop gap export for " + std::string{infoOf(target).title} + ".",
      "SI units; frames of links: x left, y up, z forward at joint zero. Taken at P register " +
          shortest(settings.p_register) + " and " + shortest(settings.temperature_c) + " degC."};
  comments.insert(comments.end(), out.approximated.begin(), out.approximated.end());
  comments.insert(comments.end(), out.lost.begin(), out.lost.end());
  if (target == Target::kMujoco) out.text = mujocoBody(of, comments);
  if (target == Target::kWebots) out.text = webotsBody(of, comments);
  if (target == Target::kUrdf) out.text = urdfBody(of, comments);
  return out;
}

}  // namespace darwinop::gap
