// Python classes of the simulator's scene tree. No object of them exists: they have constants only.
#include <webots/Field.hpp>
#include <webots/GPS.hpp>
#include <webots/Node.hpp>
#include <webots/Proto.hpp>

#include "apps/python/bindings.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"

namespace darwinop::python {

namespace {

using webots::Field;
using webots::Node;

void bindNode(py::module_& module) {
  const DeviceClass<Node> node{module, "Node"};
  constants(node, {{"NO_NODE", Node::NO_NODE},
                   {"ROBOT", Node::ROBOT},
                   {"ACCELEROMETER", Node::ACCELEROMETER},
                   {"CAMERA", Node::CAMERA},
                   {"GYRO", Node::GYRO},
                   {"LED", Node::LED},
                   {"POSITION_SENSOR", Node::POSITION_SENSOR},
                   {"ROTATIONAL_MOTOR", Node::ROTATIONAL_MOTOR},
                   {"SPEAKER", Node::SPEAKER},
                   {"TOUCH_SENSOR", Node::TOUCH_SENSOR},
                   {"ALTIMETER", Node::ALTIMETER},
                   {"APPEARANCE", Node::APPEARANCE},
                   {"BACKGROUND", Node::BACKGROUND},
                   {"BALL_JOINT", Node::BALL_JOINT},
                   {"BALL_JOINT_PARAMETERS", Node::BALL_JOINT_PARAMETERS},
                   {"BILLBOARD", Node::BILLBOARD},
                   {"BOX", Node::BOX},
                   {"BRAKE", Node::BRAKE},
                   {"CAPSULE", Node::CAPSULE},
                   {"CHARGER", Node::CHARGER},
                   {"COLOR", Node::COLOR},
                   {"COMPASS", Node::COMPASS},
                   {"CONE", Node::CONE},
                   {"CONNECTOR", Node::CONNECTOR},
                   {"CONTACT_PROPERTIES", Node::CONTACT_PROPERTIES},
                   {"COORDINATE", Node::COORDINATE},
                   {"CYLINDER", Node::CYLINDER},
                   {"DAMPING", Node::DAMPING},
                   {"DIRECTIONAL_LIGHT", Node::DIRECTIONAL_LIGHT},
                   {"DISPLAY", Node::DISPLAY},
                   {"DISTANCE_SENSOR", Node::DISTANCE_SENSOR},
                   {"ELEVATION_GRID", Node::ELEVATION_GRID},
                   {"EMITTER", Node::EMITTER},
                   {"FLUID", Node::FLUID},
                   {"FOCUS", Node::FOCUS},
                   {"FOG", Node::FOG},
                   {"GPS", Node::GPS},
                   {"GROUP", Node::GROUP},
                   {"HINGE_2_JOINT", Node::HINGE_2_JOINT},
                   {"HINGE_JOINT", Node::HINGE_JOINT},
                   {"HINGE_JOINT_PARAMETERS", Node::HINGE_JOINT_PARAMETERS},
                   {"IMAGE_TEXTURE", Node::IMAGE_TEXTURE},
                   {"IMMERSION_PROPERTIES", Node::IMMERSION_PROPERTIES},
                   {"INDEXED_FACE_SET", Node::INDEXED_FACE_SET},
                   {"INDEXED_LINE_SET", Node::INDEXED_LINE_SET},
                   {"INERTIAL_UNIT", Node::INERTIAL_UNIT},
                   {"JOINT_PARAMETERS", Node::JOINT_PARAMETERS},
                   {"LENS", Node::LENS},
                   {"LENS_FLARE", Node::LENS_FLARE},
                   {"LIDAR", Node::LIDAR},
                   {"LIGHT_SENSOR", Node::LIGHT_SENSOR},
                   {"LINEAR_MOTOR", Node::LINEAR_MOTOR},
                   {"MATERIAL", Node::MATERIAL},
                   {"MESH", Node::MESH},
                   {"MICROPHONE", Node::MICROPHONE},
                   {"MUSCLE", Node::MUSCLE},
                   {"NORMAL", Node::NORMAL},
                   {"PBR_APPEARANCE", Node::PBR_APPEARANCE},
                   {"PEN", Node::PEN},
                   {"PHYSICS", Node::PHYSICS},
                   {"PLANE", Node::PLANE},
                   {"POINT_LIGHT", Node::POINT_LIGHT},
                   {"POINT_SET", Node::POINT_SET},
                   {"POSE", Node::POSE},
                   {"PROPELLER", Node::PROPELLER},
                   {"RADAR", Node::RADAR},
                   {"RADIO", Node::RADIO},
                   {"RANGE_FINDER", Node::RANGE_FINDER},
                   {"RECEIVER", Node::RECEIVER},
                   {"RECOGNITION", Node::RECOGNITION},
                   {"SHAPE", Node::SHAPE},
                   {"SKIN", Node::SKIN},
                   {"SLIDER_JOINT", Node::SLIDER_JOINT},
                   {"SLOT", Node::SLOT},
                   {"SOLID", Node::SOLID},
                   {"SOLID_REFERENCE", Node::SOLID_REFERENCE},
                   {"SPHERE", Node::SPHERE},
                   {"SPOT_LIGHT", Node::SPOT_LIGHT},
                   {"TEXTURE_COORDINATE", Node::TEXTURE_COORDINATE},
                   {"TEXTURE_TRANSFORM", Node::TEXTURE_TRANSFORM},
                   {"TRACK", Node::TRACK},
                   {"TRACK_WHEEL", Node::TRACK_WHEEL},
                   {"TRANSFORM", Node::TRANSFORM},
                   {"VACUUM_GRIPPER", Node::VACUUM_GRIPPER},
                   {"VIEWPOINT", Node::VIEWPOINT},
                   {"WORLD_INFO", Node::WORLD_INFO},
                   {"ZOOM", Node::ZOOM},
                   {"CAMERA_ZOOM", Node::CAMERA_ZOOM},
                   {"DIFFERENTIAL_WHEELS", Node::DIFFERENTIAL_WHEELS},
                   {"SERVO", Node::SERVO},
                   {"SUPERVISOR", Node::SUPERVISOR}});
}

void bindField(py::module_& module) {
  const DeviceClass<Field> field{module, "Field"};
  constants(field, {{"NO_FIELD", Field::NO_FIELD},
                    {"SF_BOOL", Field::SF_BOOL},
                    {"SF_INT32", Field::SF_INT32},
                    {"SF_FLOAT", Field::SF_FLOAT},
                    {"SF_VEC2F", Field::SF_VEC2F},
                    {"SF_VEC3F", Field::SF_VEC3F},
                    {"SF_ROTATION", Field::SF_ROTATION},
                    {"SF_COLOR", Field::SF_COLOR},
                    {"SF_STRING", Field::SF_STRING},
                    {"SF_NODE", Field::SF_NODE},
                    {"MF", Field::MF},
                    {"MF_BOOL", Field::MF_BOOL},
                    {"MF_INT32", Field::MF_INT32},
                    {"MF_FLOAT", Field::MF_FLOAT},
                    {"MF_VEC2F", Field::MF_VEC2F},
                    {"MF_VEC3F", Field::MF_VEC3F},
                    {"MF_ROTATION", Field::MF_ROTATION},
                    {"MF_COLOR", Field::MF_COLOR},
                    {"MF_STRING", Field::MF_STRING},
                    {"MF_NODE", Field::MF_NODE}});
}

void warnOfCall(const std::string& call) {
  webots_api::warnOnce("Supervisor::" + call + webots_api::messages::kNoSceneTree);
}

}  // namespace

void bindScene(py::module_& module) {
  bindNode(module);
  bindField(module);
  const DeviceClass<webots::Proto> proto{module, "Proto"};
  // For what is written in Python, in apps/python/controller/.
  module.def("warn_of_supervisor_call", &warnOfCall, py::arg("call"));
  module.def("degrees_minutes_seconds", &webots::GPS::convertToDegreesMinutesSeconds, py::arg("decimalDegrees"));
}

}  // namespace darwinop::python
