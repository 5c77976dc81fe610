#include "gap/report/body/body_additions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "gap/identify/body/answer_model.hpp"
#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/plant/body/model_with.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/messages.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using Axes3 = std::array<double, 3>;

/// What a person can read; the intervals are wider by far.
double sixDigits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

const json& resultOf(const json& all, const std::string& name) {
  if (all.is_object() && all.at("case") == name) return all;
  if (all.is_object()) throw std::runtime_error("is of case " + all.at("case").get<std::string>() + ", not of " + name);
  for (const json& one : all)
    if (one.value("case", "") == name) return one;
  throw std::runtime_error("has no result of case " + name);
}

/// Joints whose own numbers are equal, by that number, which an addition is on top of.
std::map<double, std::vector<Joint>> byOwn(const BodyHypothesis& robot, const std::string& id, const json& at) {
  const auto effect = std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
  if (effect == mechanicalEffects().end()) throw std::runtime_error("has " + id + ", which adds to nothing");
  std::map<double, std::vector<Joint>> out;
  for (const Joint joint : jointsAt(at)) out[ownNumber(robot, *effect, joint)].push_back(joint);
  return out;
}

/// `own`: of these joints, which get it and what is added; a total is the same in all.
AddedEffect servoEffect(const json& from, const std::string& because, std::vector<Joint> joints,
                        std::optional<double> own) {
  AddedEffect effect{.id = from.at("id"), .values = {}, .because = {because}, .joints = std::move(joints)};
  const json intervals = from.value("interval_90", json::object());
  for (const auto& [name, value] : from.at("params").items()) {
    const bool is_added = name.ends_with(kAddedEnding);
    const std::string key = is_added ? name.substr(0, name.size() - kAddedEnding.size()) : name;
    if (is_added != (own && from.at("params").contains(key + std::string{kAddedEnding}))) continue;
    const double by = is_added ? *own : 0;
    AddedValue added{key, sixDigits(std::max(is_added ? 0.0 : value.get<double>(), by + value.get<double>())),
                     std::nan(""), std::nan("")};
    if (intervals.contains(name) && intervals[name].size() == 2 && intervals[name][0].is_number())
      added.low = by + intervals[name][0].get<double>(), added.high = by + intervals[name][1].get<double>();
    effect.values.push_back(added);
  }
  return effect;
}

/// One section each for joints that have different numbers of their own. `robot`: with the effects before this one.
std::vector<AddedEffect> servoEffects(const json& from, const std::string& because, const BodyHypothesis& robot) {
  const json& at = from.at("at");
  const std::vector<Joint> all = at == "all" ? std::vector<Joint>{} : jointsAt(at);
  const auto items = from.at("params").items();
  if (std::none_of(items.begin(), items.end(), [](const auto& item) { return item.key().ends_with(kAddedEnding); }))
    return {servoEffect(from, because, all, {})};
  const std::map<double, std::vector<Joint>> groups = byOwn(robot, from.at("id"), at);
  std::vector<AddedEffect> out;
  for (const auto& [own, joints] : groups)
    out.push_back(servoEffect(from, because, groups.size() == 1 ? all : joints, own));
  return out;
}

/// Every key whose value the two models do not share.
void addChangedKeys(const twin::Model& was, const twin::Model& now, Additions& into) {
  twin::Model old_model = was, new_model = now;
  for (const twin::KeyRow& row : twin::keyTable()) {
    if (twin::writeValue(was, row) == twin::writeValue(now, row)) continue;
    const twin::Slot before = row.in(old_model), after = row.in(new_model);
    if (auto* const* const number = std::get_if<double*>(&after))
      into.numbers.push_back(
          {.key = std::string{row.key}, .value = sixDigits(**number), .section = std::string{row.section}});
    else if (auto* const* const axes = std::get_if<Axes3*>(&after)) {
      AddedAxes added{std::string{row.section}, std::string{row.key}, **axes};
      for (std::size_t i = 0; i < added.values.size(); ++i)
        if (added.values[i] != (*std::get<Axes3*>(before))[i]) added.values[i] = sixDigits(added.values[i]);
      into.axes.push_back(std::move(added));
    }
  }
}

}  // namespace

BodyAdditions bodyAdditionsIn(std::string_view results, const std::string& file, const std::string& name,
                              const twin::Model& model) {
  try {
    const json all = json::parse(results);
    const json& result = resultOf(all, name);
    if (result.at("effects").empty())
      throw std::runtime_error("has the verdict " + result.at("verdict").get<std::string>() + ", which " +
                               messages::kNamesNoEffect + ": there is nothing to add");
    const std::string because =
        "Found by darwinop gap in case " + name + ", verdict " + result.at("verdict").get<std::string>();
    BodyAdditions out;
    AnsweredRobot robot = unchangedRobot(model);
    for (const json& effect : result.at("effects")) {
      if (twin::findEffect(effect.at("id").get<std::string>()) != nullptr)
        std::ranges::move(servoEffects(effect, because, robot.model.robot.robot),
                          std::back_inserter(out.additions.effects));
      addEffect(robot, effect, model);
    }
    ModelWith changed = modelWith(model, robot.model.robot, robot.model.imu);
    changed.model.body.battery_resistance_ohm += robot.battery_ohm;
    addChangedKeys(model, changed.model, out.additions);
    out.left_out = std::move(changed.conflicts);
    return out;
  } catch (const json::exception& error) {
    throw std::runtime_error(file + ": " + messages::kNotAResult + " (" + error.what() +
                             "); `darwinop gap run` writes report.json");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

std::string otherModelWarning(std::string_view results, const std::string& file, const std::string& name,
                              std::string_view model) {
  const json all = json::parse(results);
  const json& result = resultOf(all, name);
  return !result.contains(kModelHash) || result[kModelHash] == sha256(model) ? "" : file + messages::kOtherModel;
}

}  // namespace darwinop::gap
