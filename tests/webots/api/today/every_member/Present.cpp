// Devices that the robot has.
#include "EveryMember.hpp"

#include <webots/Accelerometer.hpp>
#include <webots/Brake.hpp>
#include <webots/Camera.hpp>
#include <webots/Gyro.hpp>
#include <webots/Joystick.hpp>
#include <webots/Keyboard.hpp>
#include <webots/LED.hpp>
#include <webots/Motor.hpp>
#include <webots/Mouse.hpp>
#include <webots/Node.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>
#include <webots/Servo.hpp>
#include <webots/Speaker.hpp>
#include <webots/TouchSensor.hpp>
#include <webots/utils/AnsiCodes.hpp>
#include <webots/utils/Motion.hpp>

using namespace webots;
using namespace std;

void useRobot(Robot *robot) {
  robot->step(16);
  robot->stepBegin(16);
  robot->stepEnd();
  const Robot::UserInputEvent event = robot->waitForUserInputEvent(Robot::EVENT_KEYBOARD, 0);
  if (event != Robot::EVENT_QUIT && event != Robot::EVENT_NO_EVENT && event != Robot::EVENT_MOUSE_CLICK &&
      event != Robot::EVENT_MOUSE_MOVE && event != Robot::EVENT_JOYSTICK_BUTTON && event != Robot::EVENT_JOYSTICK_AXIS &&
      event != Robot::EVENT_JOYSTICK_POV)
    return;
  string text = robot->getName() + robot->getUrdf() + robot->getUrdf("prefix") + robot->getModel() + robot->getProjectPath() +
                robot->getWorldPath();
  robot->setCustomData(text);
  text = robot->getCustomData();
  robot->setData(text);
  text = robot->getData();
  text = robot->getControllerName() + robot->getControllerArguments();
  robot->getTime();
  robot->getBasicTimeStep();
  const Robot::Mode mode = robot->getMode();
  if (mode != Robot::MODE_SIMULATION && mode != Robot::MODE_REMOTE_CONTROL && mode != Robot::MODE_CROSS_COMPILATION)
    return;
  robot->setMode(Robot::MODE_SIMULATION, NULL);
  robot->getSupervisor();
  robot->getSynchronization();
  robot->getType();
  for (int i = 0; i < robot->getNumberOfDevices(); ++i) {
    Device *device = robot->getDeviceByIndex(i);
    const string &name = device->getName();
    if (robot->getDevice(name) != device)
      return;
    device->getModel();
    device->getTag();
    if (device->getNodeType() == Node::NO_NODE || device->getType() == Node::CAMERA_ZOOM)
      return;
  }
  robot->batterySensorEnable(16);
  robot->batterySensorGetSamplingPeriod();
  robot->batterySensorGetValue();
  robot->batterySensorDisable();
  robot->wwiSend("text", 5);
  robot->wwiSendText("text");
  int size = 0;
  robot->wwiReceive(&size);
  robot->wwiReceiveText();
  robot->windowCustomFunction(NULL);
  Robot::getInstance();
}

static void useMotor(Motor *motor) {
  motor->setPosition(0.1);
  motor->setVelocity(1);
  motor->setAcceleration(-1);
  motor->setControlPID(10, 0, 0);
  motor->setAvailableTorque(2.5);
  motor->setAvailableForce(2.5);
  motor->getTargetPosition();
  motor->getMinPosition();
  motor->getMaxPosition();
  motor->getVelocity();
  motor->getMaxVelocity();
  motor->getAcceleration();
  motor->getAvailableForce();
  motor->getMaxForce();
  motor->getAvailableTorque();
  motor->getMaxTorque();
  motor->getMultiplier();
  motor->enableForceFeedback(16);
  motor->getForceFeedback();
  motor->getForceFeedbackSamplingPeriod();
  motor->disableForceFeedback();
  motor->enableTorqueFeedback(16);
  motor->getTorqueFeedback();
  motor->getTorqueFeedbackSamplingPeriod();
  motor->disableTorqueFeedback();
  motor->setForce(0);
  motor->setTorque(0);
  const Motor::Type type = motor->getType();
  if (type == Motor::LINEAR || type != Motor::ROTATIONAL)
    return;
  Brake *brake = motor->getBrake();
  if (brake != NULL)
    brake->setDampingConstant(1);
  motor->getPositionSensor();
  // Names of 2013.
  motor->enablePosition(16);
  motor->getPosition();
  motor->getPositionSamplingPeriod();
  motor->disablePosition();
}

void useMotors(Robot *robot) {
  useMotor(robot->getMotor("Neck"));
  Servo *servo = robot->getServo("Head");
  useMotor(servo);
  servo->setMotorForce(2.5);
  servo->setControlP(4);
  servo->enableMotorForceFeedback(16);
  servo->getMotorForceFeedback();
  servo->getMotorForceFeedbackSamplingPeriod();
  servo->disableMotorForceFeedback();
  servo->getSamplingPeriod();

  LED *led = robot->getLED("EyeLed");
  led->set(0xFF0000);
  led->get();

  Motion motion("wave.motion");
  motion.setLoop(false);
  motion.setReverse(false);
  motion.play();
  motion.setTime(0);
  motion.stop();
  motion.isValid();
  motion.isOver();
  motion.getTime();
  motion.getDuration();
  string colours = ANSI_RESET ANSI_BOLD ANSI_UNDERLINE ANSI_BLACK_BACKGROUND ANSI_RED_BACKGROUND ANSI_GREEN_BACKGROUND
    ANSI_YELLOW_BACKGROUND ANSI_BLUE_BACKGROUND ANSI_MAGENTA_BACKGROUND ANSI_CYAN_BACKGROUND ANSI_WHITE_BACKGROUND
    ANSI_BLACK_FOREGROUND ANSI_RED_FOREGROUND ANSI_GREEN_FOREGROUND ANSI_YELLOW_FOREGROUND ANSI_BLUE_FOREGROUND
    ANSI_MAGENTA_FOREGROUND ANSI_CYAN_FOREGROUND ANSI_WHITE_FOREGROUND ANSI_CLEAR_SCREEN;
}

void useSensors(Robot *robot) {
  Accelerometer *accelerometer = robot->getAccelerometer("Accelerometer");
  accelerometer->enable(16);
  accelerometer->getSamplingPeriod();
  accelerometer->getValues();
  accelerometer->getLookupTableSize();
  accelerometer->getLookupTable();
  accelerometer->disable();

  Gyro *gyro = robot->getGyro("Gyro");
  gyro->enable(16);
  gyro->getSamplingPeriod();
  gyro->getValues();
  gyro->getLookupTableSize();
  gyro->getLookupTable();
  gyro->disable();

  PositionSensor *position = robot->getPositionSensor("NeckS");
  position->enable(16);
  position->getSamplingPeriod();
  position->getValue();
  const PositionSensor::Type kind = position->getType();
  if (kind == PositionSensor::LINEAR || kind != PositionSensor::ROTATIONAL)
    return;
  position->getBrake();
  position->getMotor();
  position->disable();

  TouchSensor *button = robot->getTouchSensor("ButtonStart");
  button->enable(16);
  button->getSamplingPeriod();
  button->getValue();
  button->getValues();
  button->getLookupTableSize();
  button->getLookupTable();
  const TouchSensor::Type type = button->getType();
  if (type == TouchSensor::FORCE || type == TouchSensor::FORCE3D || type != TouchSensor::BUMPER)
    return;
  button->disable();
}

void useCamera(Robot *robot) {
  Camera *camera = robot->getCamera("Camera");
  camera->enable(32);
  camera->getSamplingPeriod();
  const unsigned char *image = camera->getImage();
  const int width = camera->getWidth();
  if (image != NULL && camera->getHeight() > 0) {
    Camera::imageGetRed(image, width, 0, 0);
    Camera::imageGetGreen(image, width, 0, 0);
    Camera::imageGetBlue(image, width, 0, 0);
    Camera::imageGetGray(image, width, 0, 0);
    Camera::imageGetGrey(image, width, 0, 0);
  }
  camera->getFov();
  camera->getMinFov();
  camera->getMaxFov();
  camera->setFov(1);
  camera->getExposure();
  camera->setExposure(1);
  camera->getFocalLength();
  camera->getFocalDistance();
  camera->getMinFocalDistance();
  camera->getMaxFocalDistance();
  camera->setFocalDistance(1);
  camera->getNear();
  camera->getType();
  camera->saveImage("picture.png", 100);
  Camera::checkResolution(320, 240);
  const float *range = camera->getRangeImage();
  if (range != NULL && Camera::rangeImageGetDepth(range, width, 0, 0) > camera->getMaxRange())
    return;
  camera->hasRecognition();
  camera->recognitionEnable(32);
  camera->getRecognitionSamplingPeriod();
  const CameraRecognitionObject *objects = camera->getRecognitionObjects();
  double sum = 0;
  for (int i = 0; i < camera->getRecognitionNumberOfObjects(); ++i) {
    const CameraRecognitionObject &seen = objects[i];
    sum += seen.id + seen.position[2] + seen.orientation[3] + seen.size[1] + seen.position_on_image[1] +
           seen.size_on_image[1] + seen.number_of_colors + seen.colors[0] + seen.model[0];
  }
  if (sum > 0)
    return;
  camera->hasRecognitionSegmentation();
  camera->enableRecognitionSegmentation();
  camera->isRecognitionSegmentationEnabled();
  camera->getRecognitionSegmentationImage();
  camera->saveRecognitionSegmentationImage("segments.png", 100);
  camera->disableRecognitionSegmentation();
  camera->recognitionDisable();
  camera->disable();
}

void useSpeaker(Robot *robot) {
  Speaker *speaker = robot->getSpeaker("Speaker");
  speaker->setEngine("pico");
  speaker->getEngine();
  speaker->setLanguage("en-US");
  speaker->getLanguage();
  Speaker::playSound(speaker, speaker, "missing.wav", 1.0, 1.0, 0.0, false);
  speaker->isSoundPlaying("missing.wav");
  speaker->speak("text", 1.0);
  speaker->isSpeaking();
  speaker->stop("");
  // Names of 2013.
  speaker->enable(16);
  speaker->playFile("missing.wav");
  speaker->playFileWait("missing.wav");
  speaker->speak("text", "en", 175);
  speaker->speakFile("missing.txt", "en", 175);
  speaker->disable();
}

void useInputs(Robot *robot) {
  Keyboard *keyboard = robot->getKeyboard();
  Keyboard made;
  made.enable(16);
  keyboard->enable(16);
  keyboard->getSamplingPeriod();
  switch (keyboard->getKey() & Keyboard::KEY) {
    case Keyboard::END:
    case Keyboard::HOME:
    case Keyboard::LEFT:
    case Keyboard::UP:
    case Keyboard::RIGHT:
    case Keyboard::DOWN:
    case Keyboard::PAGEUP:
    case Keyboard::PAGEDOWN:
    case Keyboard::NUMPAD_HOME:
    case Keyboard::NUMPAD_LEFT:
    case Keyboard::NUMPAD_UP:
    case Keyboard::NUMPAD_RIGHT:
    case Keyboard::NUMPAD_DOWN:
    case Keyboard::NUMPAD_END:
    case Keyboard::SHIFT + Keyboard::CONTROL + Keyboard::ALT:
      return;
  }
  keyboard->disable();
  robot->keyboardEnable(16);
  if (robot->keyboardGetKey() == Robot::KEYBOARD_UP)
    return;
  robot->keyboardDisable();

  Joystick *joystick = robot->getJoystick();
  Joystick own;
  own.enable(16);
  joystick->enable(16);
  joystick->getSamplingPeriod();
  joystick->isConnected();
  joystick->getModel();
  for (int i = 0; i < joystick->getNumberOfAxes(); ++i)
    joystick->getAxisValue(i);
  for (int i = 0; i < joystick->getNumberOfPovs(); ++i)
    joystick->getPovValue(i);
  joystick->getPressedButton();
  joystick->setConstantForce(1);
  joystick->setConstantForceDuration(1);
  joystick->setAutoCenteringGain(1);
  joystick->setResistanceGain(1);
  joystick->setForceAxis(0);
  joystick->disable();

  Mouse *mouse = robot->getMouse();
  Mouse other;
  other.enable(16);
  mouse->enable(16);
  mouse->getSamplingPeriod();
  mouse->enable3dPosition();
  mouse->is3dPositionEnabled();
  const MouseState state = mouse->getState();
  if (state.left || state.middle || state.right || state.u + state.v + state.x + state.y + state.z > 0)
    return;
  mouse->disable3dPosition();
  mouse->disable();
}
