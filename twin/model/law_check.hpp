// Which control law a joint has, and whether an effect can act under it.
#pragma once

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// The setting of this effect that acts at `joint`: its own, else that for all joints. Null: the model has none.
const EffectSetting* settingAt(const Model& model, const EffectInfo& effect, Joint joint);

/// The first parameter of `setting` that is not neutral and has no equation of motion under the law of its joints.
/// Null: all have one, at least in one joint.
const Parameter* withoutEquation(const Model& model, const EffectSetting& setting);
/// Why a model is refused for it, and what to do: " moves nothing under the law speed_p; ...".
std::string lawAdvice(const EffectInfo& effect, const Parameter& parameter);

}  // namespace darwinop::twin
