// The exam of the whole robot: goals and figures.
#pragma once

#include "gap/benchmark/score/body/body_answers.hpp"
#include "gap/benchmark/score/score.hpp"

namespace darwinop::gap {

/// Names of the figures.
namespace body_figures {
inline constexpr const char* kSensor = "sensor: effect";
inline constexpr const char* kSensorNumber = "sensor, named: number within 5 % or 3 quanta";
inline constexpr const char* kMass = "mass, centre of mass: effect and link, or doubt";
inline constexpr const char* kMassNumber = "mass, named: number within 10 %";
inline constexpr const char* kContact = "contact, floor: effect";
inline constexpr const char* kContactNumber = "contact, named: number within 20 %";
inline constexpr const char* kOneJoint = "one joint: effect";
inline constexpr const char* kOneJointPlace = "one joint: joint";
inline constexpr const char* kManyJoints = "pair or all joints: effect";
inline constexpr const char* kManyJointsPlace = "pair or all joints: set of joints";
inline constexpr const char* kBus = "battery, bus: effect";
inline constexpr const char* kBusNumber = "battery, bus, named: number within 10 %";
inline constexpr const char* kTwoBoth = "two effects: both";
inline constexpr const char* kTwoFirst = "two effects: the first is one of them";
inline constexpr const char* kExactAlarm = "nothing hidden, exact: false alarm";
inline constexpr const char* kWrongAlarm = "nothing hidden, numbers wrong: false alarm";
inline constexpr const char* kFalseName = "nothing hidden: a name";
inline constexpr const char* kOutside = "outside: no false name";
inline constexpr const char* kOutsidePlace = "outside: place right";
}  // namespace body_figures

Score bodyScoreOf(const BodyKeys& keys, const BodyAnswers& answers);

}  // namespace darwinop::gap
