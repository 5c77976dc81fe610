// What additions do to a model, for a terminal.
#include <algorithm>
#include <iterator>

#include "gap/report/addition.hpp"
#include "gap/report/joint_numbers.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// The sections of `model` that this effect replaces: " at NAME" of joints, "" of all.
std::vector<std::string> placesIn(const twin::Model& model, const std::string& id) {
  std::vector<std::string> places;
  for (const twin::EffectSetting& there : model.effects)
    if (there.info->id == id)
      places.push_back(there.joint ? " at " + std::string{row(*there.joint).name} : std::string{});
  return places;
}

/// What was not given may act as well: a torque limit has a typical duty.
std::vector<std::string> typicalValues(const AddedEffect& added) {
  std::vector<std::string> lines;
  for (const twin::Parameter& parameter : twin::findEffect(added.id)->parameters)
    if (std::ranges::find(added.values, parameter.key, &AddedValue::key) == added.values.end())
      lines.push_back("  " + added.id + "." + std::string{parameter.key} + " = " +
                      withUnit(parameter.typical, parameter.unit) + ": " + messages::kTypicalValue);
  return lines;
}

}  // namespace

std::vector<std::string> changesBy(const Additions& given, const twin::Model& before) {
  const Additions additions = withJointNumbers(given, before);
  std::vector<std::string> lines;
  for (const AddedEffect& added : additions.effects) {
    const std::vector<std::string> there = placesIn(before, added.id);
    std::vector<std::string> places;
    for (const Joint joint : added.joints) places.push_back(" at " + std::string{row(joint).name});
    if (places.empty()) {
      places.emplace_back();
      std::ranges::copy_if(there, std::back_inserter(places), [](const std::string& place) { return !place.empty(); });
    }
    bool is_new = false;
    for (const std::string& place : places) {
      const bool is_added = std::ranges::find(there, place) == there.end();
      lines.push_back(added.id + place + (is_added ? " added" : " replaced"));
      is_new |= is_added;
    }
    if (is_new) std::ranges::copy(typicalValues(added), std::back_inserter(lines));
  }
  for (const AddedNumber& number : additions.numbers)
    if (number.key.find('.') == std::string::npos)
      lines.push_back("[" + number.section + "] " + number.key + " changed, for all joints");
  return lines;
}

}  // namespace darwinop::gap
