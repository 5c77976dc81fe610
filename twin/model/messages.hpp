// Phrases that identify the errors of model files.
#pragma once

namespace darwinop::twin::messages {

// a line of the file
inline constexpr const char* kEffectSyntax =
    "write [effect NAME], or [effect NAME JOINT] for one joint, as in [effect coulomb Neck]";
inline constexpr const char* kMissing = " is missing; give ";
inline constexpr const char* kOutOfRange = "out of range; give ";
inline constexpr const char* kNoEquation = " moves nothing under the law speed_p; ";

// the file, and the body's file that it names
inline constexpr const char* kIsFolder = " is a folder; ";
inline constexpr const char* kNoBodyFile = "there is no file ";
inline constexpr const char* kNotTheBody = " is not the body of the model, ";
inline constexpr const char* kOutsideOfFolder = " is outside of the folder ";
inline constexpr const char* kNoModel = "there is no model ";
inline constexpr const char* kNoModelFile = "there is no model file ";

// what cannot be written
inline constexpr const char* kUnwritableText =
    "cannot write the model: name and body.xml must not contain quotes, ; or #, or start or end with a blank";
inline constexpr const char* kValuesMissing = "cannot write an effect without a value for each of its parameters";

}  // namespace darwinop::twin::messages
