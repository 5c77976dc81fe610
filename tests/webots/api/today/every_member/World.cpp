// The simulated world: nodes and fields are used if they exist.
#include "EveryMember.hpp"

#include <webots/Field.hpp>
#include <webots/Node.hpp>
#include <webots/Proto.hpp>
#include <webots/Supervisor.hpp>

using namespace webots;
using namespace std;

static void useOneValue(Field *field) {
  field->getName();
  field->getTypeName();
  field->getActualField();
  field->enableSFTracking(16);
  field->disableSFTracking();
  field->setSFBool(field->getSFBool());
  field->setSFInt32(field->getSFInt32());
  field->setSFFloat(field->getSFFloat());
  field->setSFVec2f(field->getSFVec2f());
  field->setSFVec3f(field->getSFVec3f());
  field->setSFRotation(field->getSFRotation());
  field->setSFColor(field->getSFColor());
  field->setSFString(field->getSFString());
  field->getSFNode();
  field->importSFNode("node.wbo");
  field->importSFNodeFromString("Ball {}");
  field->removeSF();
}

static void useList(Field *field) {
  field->insertMFBool(-1, true);
  field->insertMFInt32(-1, 1);
  field->insertMFFloat(-1, 1);
  const double values[] = {0, 0, 1, 0};
  field->insertMFVec2f(-1, values);
  field->insertMFVec3f(-1, values);
  field->insertMFRotation(-1, values);
  field->insertMFColor(-1, values);
  field->insertMFString(-1, "text");
  field->importMFNode(-1, "node.wbo");
  field->importMFNodeFromString(-1, "Ball {}");
  for (int i = 0; i < field->getCount(); ++i) {
    field->setMFBool(i, field->getMFBool(i));
    field->setMFInt32(i, field->getMFInt32(i));
    field->setMFFloat(i, field->getMFFloat(i));
    field->setMFVec2f(i, field->getMFVec2f(i));
    field->setMFVec3f(i, field->getMFVec3f(i));
    field->setMFRotation(i, field->getMFRotation(i));
    field->setMFColor(i, field->getMFColor(i));
    field->setMFString(i, field->getMFString(i));
    field->getMFNode(i);
  }
  field->removeMF(-1);
}

static void useField(Field *field) {
  if (field == NULL)
    return;
  switch (field->getType()) {
    case Field::NO_FIELD:
      return;
    case Field::SF_BOOL:
    case Field::SF_INT32:
    case Field::SF_FLOAT:
    case Field::SF_VEC2F:
    case Field::SF_VEC3F:
    case Field::SF_ROTATION:
    case Field::SF_COLOR:
    case Field::SF_STRING:
    case Field::SF_NODE:
      return useOneValue(field);
    case Field::MF:
    case Field::MF_BOOL:
    case Field::MF_INT32:
    case Field::MF_FLOAT:
    case Field::MF_VEC2F:
    case Field::MF_VEC3F:
    case Field::MF_ROTATION:
    case Field::MF_COLOR:
    case Field::MF_STRING:
    case Field::MF_NODE:
      return useList(field);
  }
}

static void useProto(Proto *proto) {
  if (proto == NULL)
    return;
  proto->getTypeName();
  proto->isDerived();
  proto->getProtoParent();
  for (int i = 0; i < proto->getNumberOfFields(); ++i)
    useField(proto->getFieldByIndex(i));
  useField(proto->getField("name"));
}

static void useNode(Node *node) {
  if (node == NULL || node->getType() == Node::NO_NODE)
    return;
  node->getId();
  const string names = node->getDef() + node->getTypeName() + node->getBaseTypeName() + node->exportString();
  node->getParentNode();
  if (node->isProto())
    useProto(node->getProto());
  for (int i = 0; i < node->getNumberOfFields(); ++i)
    useField(node->getFieldByIndex(i));
  for (int i = 0; i < node->getNumberOfBaseNodeFields(); ++i)
    useField(node->getBaseNodeFieldByIndex(i));
  for (int i = 0; i < node->getProtoNumberOfFields(); ++i)
    useField(node->getProtoFieldByIndex(i));
  useField(node->getField("translation"));
  useField(node->getBaseNodeField("translation"));
  useField(node->getProtoField("translation"));
  useNode(node->getFromProtoDef("HEAD"));
  node->getPosition();
  node->getOrientation();
  node->getPose();
  node->getPose(node);
  node->enablePoseTracking(16);
  node->enablePoseTracking(16, node);
  node->disablePoseTracking();
  node->disablePoseTracking(node);
  node->getCenterOfMass();
  int size = 0;
  node->enableContactPointsTracking(16);
  node->enableContactPointsTracking(16, true);
  const ContactPoint *contacts = node->getContactPoints(true, &size);
  if (size > 0 && contacts[0].point[2] > contacts[0].node_id)
    return;
  node->disableContactPointsTracking();
  node->disableContactPointsTracking(true);
  for (int i = 0; i < node->getNumberOfContactPoints() + node->getNumberOfContactPoints(true); ++i) {
    node->getContactPoint(i);
    node->getContactPointNode(i);
  }
  node->getStaticBalance();
  node->setVelocity(node->getVelocity());
  const double force[] = {0, 0, 1};
  node->addForce(force, false);
  node->addForceWithOffset(force, force, false);
  node->addTorque(force, true);
  node->setJointPosition(0.1);
  node->setJointPosition(0.1, 2);
  node->resetPhysics();
  node->restartController();
  node->moveViewpoint();
  node->setVisibility(node, true);
  node->saveState("start");
  node->loadState("start");
  node->remove();
}

void useWorld(Supervisor *supervisor) {
  Supervisor::getSupervisorInstance();
  useNode(supervisor->getRoot());
  useNode(supervisor->getSelf());
  useNode(supervisor->getFromDef("BALL"));
  useNode(supervisor->getFromId(1));
  useNode(supervisor->getFromDevice(supervisor->getDeviceByIndex(0)));
  useNode(supervisor->getFromDeviceTag(1));
  useNode(supervisor->getSelected());
  supervisor->setLabel(0, "text", 0, 0, 0.1, 0xFF0000);
  supervisor->setLabel(0, "text", 0, 0, 0.1, 0xFF0000, 0.5);
  supervisor->setLabel(0, "text", 0, 0, 0.1, 0xFF0000, 0.5, "Arial");
  supervisor->exportImage("picture.png", 100);
  supervisor->movieStartRecording("movie.mp4", 640, 480, 0, 90, 1, false);
  while (!supervisor->movieIsReady())
    supervisor->step(16);
  supervisor->movieFailed();
  supervisor->movieStopRecording();
  supervisor->startMovie("movie.mp4", 640, 480, 0, 90, 1, false);
  supervisor->startMovie("movie.mp4", 640, 480, 0, 90);
  supervisor->stopMovie();
  const int status = supervisor->movieGetStatus();
  if (status == Supervisor::MOVIE_RECORDING || status == Supervisor::MOVIE_SAVING || status == Supervisor::MOVIE_WRITE_ERROR ||
      status == Supervisor::MOVIE_ENCODING_ERROR || status == Supervisor::MOVIE_SIMULATION_ERROR ||
      supervisor->getMovieStatus() != Supervisor::MOVIE_READY)
    return;
  supervisor->animationStartRecording("animation.html");
  supervisor->animationStopRecording();
  supervisor->virtualRealityHeadsetIsUsed();
  supervisor->virtualRealityHeadsetGetPosition();
  supervisor->virtualRealityHeadsetGetOrientation();
  const Supervisor::SimulationMode mode = supervisor->simulationGetMode();
  supervisor->simulationSetMode(Supervisor::SIMULATION_MODE_PAUSE);
  supervisor->simulationSetMode(Supervisor::SIMULATION_MODE_RUN);
  supervisor->simulationSetMode(Supervisor::SIMULATION_MODE_FAST);
  if (mode != Supervisor::SIMULATION_MODE_REAL_TIME)
    return;
  supervisor->simulationResetPhysics();
  supervisor->simulationPhysicsReset();
  supervisor->simulationReset();
  supervisor->simulationRevert();
  supervisor->worldSave();
  supervisor->worldSave("world.wbt");
  supervisor->worldReload();
  supervisor->worldLoad("world.wbt");
  supervisor->saveWorld();
  supervisor->saveWorld("world.wbt");
  supervisor->loadWorld("world.wbt");
  supervisor->simulationQuit(0);
}
