// Writes a model as text, and creates the effects of one joint.
#include <algorithm>
#include <stdexcept>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/law_check.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/section_text.hpp"

namespace darwinop::twin {
namespace {

std::string textOf(const Model& model) {
  std::string out;
  std::vector<std::string_view> sections(plainSections().begin(), plainSections().end());
  for (std::size_t link = 0; link < kLinks; ++link)
    if (model.links[link] != LinkSettings{}) sections.push_back(linkSection(link));
  for (const std::string_view section : sections) {
    out += (out.empty() ? "[" : "\n[") + std::string{section} + "]\n";
    for (const KeyRow& row : keyTable())
      if (row.section == section) out += std::string{row.key} + " = " + writeValue(model, row) + "\n";
  }
  for (const EffectSetting& setting : model.effects) {
    out += '\n';
    for (const std::string& line : sectionLines(setting)) out += line + '\n';
  }
  return out;
}

}  // namespace

std::vector<std::string> sectionLines(const EffectSetting& setting) {
  if (setting.info == nullptr || setting.values.size() != setting.info->parameters.size())
    throw std::runtime_error(messages::kValuesMissing);
  std::vector<std::string> lines{"[" + text({.info = setting.info, .joint = setting.joint}) + "]"};
  for (std::size_t i = 0; i < setting.values.size(); ++i) {
    const Parameter& parameter = setting.info->parameters[i];
    lines.push_back(std::string{parameter.key} + " = " + writeNumber(setting.values[i], ruleOf(parameter)));
  }
  return lines;
}

std::string writeModel(const Model& model) {
  std::string text = textOf(model);
  if (textOf(parseModel(text, "the model to be written")) != text) throw std::runtime_error(messages::kUnwritableText);
  return text;
}

std::vector<std::unique_ptr<Effect>> effectsOf(const Model& model, Joint joint) {
  std::vector<std::unique_ptr<Effect>> effects;
  for (const EffectInfo* const info : catalogue()) {
    const EffectSetting* const setting = settingAt(model, *info, joint);
    if (setting != nullptr) effects.push_back(info->make(setting->values));
  }
  return effects;
}

}  // namespace darwinop::twin
