// Model files: an error message, or values in range that are written and edited without loss.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::twin;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireInRange(double value, const NumberRule& rule) {
  require((value >= rule.low && value <= rule.high) || (rule.may_be_none && value > rule.high));
}

void requireSane(Model model) {
  require(!model.name.empty());
  for (const KeyRow& row : keyTable())
    if (const Slot slot = row.in(model); std::holds_alternative<double*>(slot))
      requireInRange(*std::get<double*>(slot), row.number);
  for (const EffectSetting& effect : model.effects)
    for (std::size_t i = 0; i < effect.values.size(); ++i)
      requireInRange(effect.values.at(i), ruleOf(effect.info->parameters[i]));
  for (std::size_t i = 0; i < kJoints; ++i) effectsOf(model, static_cast<Joint>(i));
}

/// Edits of a sound file give sound files; what is put in can be taken out again.
void requireEditable(std::string_view text, const Model& model) {
  const EffectInfo& info = *catalogue()[text.size() % catalogue().size()];
  EffectSetting setting{&info, {}, static_cast<Joint>(text.size() % kJoints)};
  for (const Parameter& parameter : info.parameters) setting.values.push_back(parameter.typical);
  const std::string with = withEffect(text, setting, {"found", std::string{text}});
  bool was_there = false;
  for (const EffectSetting& effect : model.effects)
    was_there = was_there || (effect.info == &info && effect.joint == setting.joint);
  require(parseModel(with, "my.ini").effects.size() == model.effects.size() + (was_there ? 0 : 1));
  const std::string without = withoutEffect(with, info.id, setting.joint);
  const bool ended = text.ends_with('\n');
  if (!was_there && ended) require(without == text);
  for (const EffectSetting& effect : model.effects) withoutEffect(text, effect.info->id, effect.joint);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  Model model;
  try {
    model = parseModel(text, "my.ini");
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with("my.ini, line "));
    return 0;
  }
  requireSane(model);
  const std::string written = writeModel(model);
  require(writeModel(parseModel(written, "my.ini")) == written);
  requireEditable(text, model);
  return 0;
}
