// Parses and formats section names of model files.
#include "twin/model/sections.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/letter_case.hpp"
#include "core/text/nearest.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/messages.hpp"

namespace darwinop::twin {
namespace {

constexpr std::string_view kEffect = "effect";

std::vector<std::string_view> wordsOf(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != text.npos; at = text.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string quoted(std::string_view word) {
  return '"' + std::string{word} + '"';
}

const EffectInfo& effectNamed(std::string_view id) {
  if (const EffectInfo* const info = findEffect(text::lowered(id))) return *info;
  throw std::runtime_error("there is no effect " + quoted(id) + "; " + text::suggestion(id, effectIds()));
}

Joint jointNamed(std::string_view name) {
  if (const auto joint = findJoint(jointName(name))) return *joint;
  std::vector<std::string_view> names;
  names.reserve(kJoints);
  for (const JointRow& row : kJointTable) names.push_back(row.name);
  throw std::runtime_error("there is no joint " + quoted(name) + "; " + text::suggestion(name, names));
}

std::size_t linkNamed(std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t link = 0; link < kLinks; ++link) {
    names.push_back(linkName(link));
    if (text::lowered(names.back()) == text::lowered(name)) return link;
  }
  throw std::runtime_error("there is no link " + quoted(name) + "; " + text::suggestion(name, names));
}

}  // namespace

SectionName sectionFrom(std::string_view text) {
  const auto words = wordsOf(text);
  if (words.size() == 1) {
    const auto plain = std::ranges::find(plainSections(), text::lowered(words[0]));
    if (plain != plainSections().end()) return {.plain = *plain};
  }
  if (!words.empty() && text::lowered(words[0]) == kEffect) {
    if (words.size() == 1 || words.size() > 3)
      throw std::runtime_error("[" + std::string{text} + "]: " + messages::kEffectSyntax);
    SectionName name{.info = &effectNamed(words[1])};
    if (words.size() == 3) name.joint = jointNamed(words[2]);
    return name;
  }
  if (words.size() == 2 && text::lowered(words[0]) == kLinkSection) return {.plain = linkSection(linkNamed(words[1]))};
  std::string message = "there is no section [" + std::string{text} + "]; ";
  for (const std::string_view of_settings : {"robot", "offsets"})
    if (text::lowered(text) == of_settings)
      throw std::runtime_error(message + "this is a robot's settings file (docs/robot-file.md), not a model");
  if (const EffectInfo* const info = words.empty() ? nullptr : findEffect(text::lowered(words[0])))
    throw std::runtime_error(message + "write an effect as [effect " + std::string{info->id} + "]");
  std::vector<std::string_view> known(plainSections().begin(), plainSections().end());
  if (const auto near = text::nearest(text, known))
    throw std::runtime_error(message + "did you mean [" + std::string{*near} + "]?");
  throw std::runtime_error(message + "there are [model], [servo], [body], [imu], [link NAME] and [effect NAME]");
}

std::string text(const SectionName& name) {
  if (name.info == nullptr) return std::string{name.plain};
  std::string out{kEffect};
  (out += ' ') += name.info->id;
  if (name.joint) (out += ' ') += row(*name.joint).name;
  return out;
}

std::vector<std::string_view> effectIds() {
  std::vector<std::string_view> ids;
  for (const EffectInfo* info : catalogue()) ids.push_back(info->id);
  return ids;
}

std::vector<std::string_view> parametersOf(const EffectInfo& info) {
  std::vector<std::string_view> keys;
  for (const Parameter& parameter : info.parameters) keys.push_back(parameter.key);
  return keys;
}

}  // namespace darwinop::twin
