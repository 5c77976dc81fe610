// The baseline model: its numbers, their priors, and the data sheet.
#include <algorithm>
#include <array>

#include "core/text/nearest.hpp"
#include "gap/case/baseline_keys.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

// The servo family whose firmware acts every 0.1 ms has an encoder finer than the resolution of its registers.
constexpr double kFineFirmware = 2e-4;  // s
/// Numbers of the servo that no search moves.
constexpr std::array<std::string_view, 5> kNeverMoved{"duty_max", "speed_max", "torque_max", "firmware_period",
                                                      "ticks_per_rev"};
const std::vector<std::string_view> kLawNames{"voltage_p", "speed_p"};

void addFriction(const FrictionKey& key, double value, twin::Model& model) {
  if (value > 0) model.effects.push_back({key.effect, {value}, std::nullopt});
}

void readArm(Fields& from, Case& into) {
  for (const ArmKey& key : armKeys()) {
    if (key.member == nullptr) continue;
    const bool of_logs = !into.logs.empty() && std::ranges::all_of(into.logs, [&](const Trajectory& log) {
      return (log.*key.of_log).has_value();
    });
    if (of_logs && !from.has(key.json))
      into.pendulum.*key.member = *(into.logs.front().*key.of_log);
    else
      into.pendulum.*key.member = from.number(key.json, key.rule);
  }
}

/// `baseline`: returns the names of the numbers that it has.
std::vector<std::string_view> readBaseline(Fields baseline, Case& into) {
  std::vector<std::string_view> given;
  twin::ServoParameters& servo = into.model.servo;
  servo.law = static_cast<twin::Law>(baseline.word("model", kLawNames, kLawNames.size()));
  const bool voltage = servo.law == twin::Law::kVoltageP;
  Fields params = baseline.object("params");
  const twin::NumberRule period = twin::findKey("servo", "firmware_period")->number;
  into.quantised = params.flag("position_in_ticks", params.number("firmware_dt_s", period) > kFineFirmware);
  for (const ServoKey& key : servoKeys()) {
    bool needed = voltage ? key.of_voltage_p : key.of_speed_p;
    if (key.key == "ticks_per_rev") needed = into.quantised;  // else of the log alone
    if (!needed && !params.has(key.json)) continue;
    servo.*key.member = params.number(key.json, ruleOf(key));
    if (key.key == "kt") servo.back_emf_vs_rad = servo.kt_nm_a;  // of the equations of a case
    given.push_back(key.key);
  }
  for (const FrictionKey& key : frictionKeys()) {
    addFriction(key, params.number(key.json, twin::ruleOf(key.effect->parameters[0])), into.model);
  }
  readArm(params, into);
  params.finish();
  baseline.finish();
  return given;
}

/// Effects for single joints are a robot's; whose servo it is has to be known.
void requireJoint(const twin::Model& model, Fields& top) {
  for (const twin::EffectSetting& effect : model.effects)
    if (effect.joint)
      top.fail("model", "has [effect " + std::string{effect.info->id} +
                            "] for one joint; give in `logs` the joint that the "
                            "logs are of: \"joint\": \"ArmUpperR\"");
}

/// Whether the model has the parameter "coulomb.friction". Unknown names are typing errors.
bool hasParameter(const std::string& name, const Case& c, const Fields& priors, std::string_view key) {
  const std::size_t dot = name.find('.');
  const twin::EffectInfo* info = twin::findEffect(name.substr(0, dot));
  if (info == nullptr ||
      std::ranges::find(info->parameters, name.substr(dot + 1), &twin::Parameter::key) == info->parameters.end())
    priors.fail(key, std::string{messages::kUnknownParameter} + "; docs/twin/effects.md has them all");
  return std::ranges::find(c.model.effects, info, &twin::EffectSetting::info) != c.model.effects.end();
}

void readPriors(Fields priors, const std::vector<std::string_view>& given, Case& into) {
  const auto take = [&](std::string_view key, std::string_view name, bool is_there) {
    const bool known_already = std::ranges::find(into.priors, name, &Prior::number) != into.priors.end();
    if (!priors.has(key)) return;
    if (known_already) priors.fail(key, std::string{messages::kSecondSigma} + "; keep one of the two");
    const double sigma = priors.number(key, kRelativeSigma);
    if (std::ranges::find(kNeverMoved, name) != kNeverMoved.end()) {
      into.warnings.push_back(priors.file() + ": prior_rel_sigma " + std::string{key} + " " + messages::kNeverMoved);
      return;
    }
    if (is_there) into.priors.push_back({std::string{name}, sigma});  // else: of what the baseline does not have
  };
  for (const ServoKey& key : servoKeys()) {
    const bool is_there = std::ranges::find(given, key.key) != given.end();
    take(key.json, key.key, is_there);
    if (key.json != key.key) take(key.key, key.key, is_there);
  }
  take("back_emf", "back_emf", true);
  for (const ArmKey& key : armKeys())
    for (const std::string_view name : {key.json, key.prior})
      take(name, key.prior, key.member == nullptr || into.pendulum.*key.member > 0);
  for (const FrictionKey& key : frictionKeys())
    take(key.json, key.prior, hasParameter(std::string{key.prior}, into, priors, key.json));
  for (const std::string& key : priors.keys())
    if (key.find('.') != std::string::npos) take(key, key, hasParameter(key, into, priors, key));
  priors.finish(into.warnings);
}

}  // namespace

std::vector<twin::EffectSetting> servoEffects(const twin::Model& model, std::optional<Joint> joint) {
  std::vector<twin::EffectSetting> kept;
  for (const twin::EffectSetting& effect : model.effects) {
    if (effect.joint && effect.joint != joint) continue;
    std::erase_if(kept, [&](const twin::EffectSetting& other) { return other.info == effect.info && effect.joint; });
    const bool there =
        std::ranges::any_of(kept, [&](const twin::EffectSetting& other) { return other.info == effect.info; });
    if (!there) kept.push_back({effect.info, effect.values, std::nullopt});
  }
  return kept;
}

void readModelPart(Fields& top, const CaseFiles& files, std::optional<Joint> joint, Case& into) {
  std::vector<std::string_view> given;
  const bool own = top.has("model");
  if (own && top.has("baseline")) top.fail("model", std::string{messages::kTwoModels} + "; keep one of the two");
  if (own) {
    try {
      into.model = files.model(top.text("model"));
    } catch (const std::runtime_error& error) {
      throw BadInput(error.what());
    }
    if (!joint) requireJoint(into.model, top);
    into.model.effects = servoEffects(into.model, joint);
    into.quantised = top.flag("position_in_ticks", into.model.servo.firmware_period_s > kFineFirmware);
    Fields arm = top.object("arm");
    readArm(arm, into);
    arm.finish();
    for (const ServoKey& key : servoKeys()) given.push_back(key.key);
  } else {
    into.model.name = into.name;
  }
  // The sheet stands in for what the baseline does not say, and takes from it what it does not say itself.
  Case alone = into;
  if (!own) readBaseline(top.object("baseline"), alone);
  if (top.has("servo_datasheet"))
    into.datasheet = readDatasheet(top.object("servo_datasheet"), alone.model.servo, into.warnings);
  if (!own && into.datasheet) into.model.servo = into.datasheet->servo;
  if (!own) given = readBaseline(top.object("baseline"), into);
  if (top.has("prior_rel_sigma")) readPriors(top.object("prior_rel_sigma"), given, into);
}

}  // namespace darwinop::gap
