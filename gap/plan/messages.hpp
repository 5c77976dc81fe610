// Phrases that identify why an experiment or an effect is refused.
#pragma once

namespace darwinop::gap::messages {

// a phase that cannot be predicted
inline constexpr const char* kEndDependsOnMotion = "its end depends on the joint's motion";
inline constexpr const char* kTorqueNotLogged = "it commands a torque, and logs record goals only";
inline constexpr const char* kTorqueLimitNotLogged = "it changes the torque limit, which logs do not record";

// a phase that no experiment file can have
inline constexpr const char* kGainBeyondFormat =
    " is its P gain, register / 8: write it for your own controller, as an experiment has at most ";

// an effect of --against
inline constexpr const char* kEffectGivenTwice = "is given twice in --against";
inline constexpr const char* kEffectNotFittable = "cannot be fitted here";

// motions of the whole robot on the floor
inline constexpr const char* kFloorMotion =
    "record it as the others on the floor, not by the runtime; case.json, with its \"battery_V\": ";
inline constexpr const char* kFloorNotPlanned =
    "Not planned, as no recording of the runtime on the floor is simulated: ";

}  // namespace darwinop::gap::messages
