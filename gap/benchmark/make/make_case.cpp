#include "gap/benchmark/make/make_case.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/text/nearest.hpp"
#include "gap/benchmark/make/key_figures.hpp"
#include "gap/benchmark/make/perturb_baseline.hpp"
#include "gap/benchmark/make/severities.hpp"
#include "gap/case/write_case.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

/// Index of a parameter in a list of them that have keys.
template <class List>
std::size_t indexOf(const List& parameters, const std::string& key, const std::string& effect) {
  const auto found = std::ranges::find_if(parameters, [&](const auto& p) { return p.key == key; });
  if (found != parameters.end()) return static_cast<std::size_t>(found - parameters.begin());
  std::vector<std::string_view> keys;
  for (const auto& parameter : parameters) keys.push_back(parameter.key);
  throw std::runtime_error("effect " + effect + " has no parameter " + key + "; " + text::suggestion(key, keys));
}

std::string numberText(double value) {
  return twin::writeNumber(value, {});
}

/// Adds one effect of the catalogue to the true bench. Returns its entry in the key.
KeyEffect add(const HiddenEffect& wanted, const twin::EffectInfo& info, const Case& given, Rng& rng, Truth& truth) {
  KeyEffect entry{wanted.id, wanted.severity, {}};
  std::vector<double> values;
  if (wanted.values.empty() && wanted.severity > 0) {
    const Strength strength = strengthOf(given, truth.bench, info, wanted.severity, rng);
    values = strength.values;
    entry.severity = strength.severity;
  } else {
    const Hypothesis before = truth.bench;
    values = truth.bench.with(info).values;
    for (std::size_t i = 0; wanted.values.empty() && i < values.size(); ++i)
      values[i] += info.parameters[i].typical - info.parameters[i].neutral;
    for (const auto& [key, value] : wanted.values) {
      const std::size_t i = indexOf(info.parameters, key, wanted.id);
      const bool on_top = before.find(info.id) != nullptr;
      values[i] = on_top ? values[i] + value : value;
      if (!(values[i] >= info.parameters[i].low && values[i] <= info.parameters[i].high))
        throw std::runtime_error("effect " + wanted.id + ": " + key + " becomes " + numberText(values[i]) + "; " +
                                 twin::allowed(twin::ruleOf(info.parameters[i])) + " is allowed");
    }
  }
  truth.bench.with(info).values = values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != info.parameters[i].neutral || !info.parameters[i].secondary)
      entry.values[std::string{info.parameters[i].key}] = values[i];
  return entry;
}

KeyEffect add(const HiddenEffect& wanted, const OutsideInfo& info, Rng& rng, Truth& truth) {
  OutsideSetting setting = drawnOutside(info, rng);
  for (const auto& [key, value] : wanted.values) setting.values[indexOf(info.parameters, key, wanted.id)] = value;
  KeyEffect entry{wanted.id, 0, {}};
  for (std::size_t i = 0; i < setting.values.size(); ++i)
    entry.values[std::string{info.parameters[i].key}] = setting.values[i];
  truth.outside.push_back(std::move(setting));
  return entry;
}

[[noreturn]] void refuse(const std::string& id) {
  std::vector<std::string_view> known;
  for (const twin::EffectInfo* const info : twin::catalogue()) known.push_back(info->id);
  for (const OutsideInfo& info : outsideCatalogue()) known.push_back(info.id);
  throw std::runtime_error("there is no effect " + id + " to hide; " + text::suggestion(id, known));
}

CaseClass classOf(const Truth& truth, std::size_t effects) {
  if (!truth.outside.empty()) return CaseClass::kOutside;
  return effects == 0 ? CaseClass::kEffectFree : effects == 1 ? CaseClass::kSingle : CaseClass::kDouble;
}

/// A name that is one folder, and nothing else.
void checkName(const std::string& name) {
  if (name.empty() || name.front() == '.' || name.find_first_of("/\\") != std::string::npos)
    throw std::runtime_error("case `" + name + "`: a case is a folder; name it by letters and digits, such as c001");
}

std::string baselineName(const CaseRequest& request, const Case& given) {
  if (!request.like) return std::string{nameOf(request.baseline)};
  if (given.model.servo.law == twin::Law::kSpeedP) return "W";
  if (!given.quantised) return "F";
  return baselineOf(given).value(twin::ParameterRole::kDryFriction) ? "CV" : "V0";
}

}  // namespace

Hidden hidden(const CaseRequest& request) {
  checkName(request.name);
  Rng rng{request.seed};
  CasePlan plan =
      request.like ? planLike(*request.like, request.name) : drawnPlan(request.name, request.baseline, rng.next());
  Key key;
  key.exact = !request.wrong_numbers;
  key.baseline = baselineName(request, plan.given);

  Truth truth{.bench = baselineOf(plan.given), .outside = {}};
  if (request.wrong_numbers) key.number_factors = makeWrong(plan.given, rng, truth.bench);
  for (const HiddenEffect& effect : request.effects) {
    if (const twin::EffectInfo* const info = twin::findEffect(effect.id))
      key.effects.push_back(add(effect, *info, plan.given, rng, truth));
    else if (const OutsideInfo* const outside = findOutside(effect.id))
      key.effects.push_back(add(effect, *outside, rng, truth));
    else
      refuse(effect.id);
  }
  key.kind = classOf(truth, request.effects.size());

  CasePlan quiet = plan;
  for (std::size_t i = 0; i < plan.given.logs.size(); ++i) {
    Disturbance disturbance = request.disturbance;
    disturbance.seed = rng.next();
    measure(plan, truth, nullptr, quiet.given.logs[i]);
    measure(plan, truth, &disturbance, plan.given.logs[i]);
  }
  compare(plan, quiet, truth, key);
  return {std::move(plan.given), std::move(key)};
}

void hide(const CaseRequest& request, const std::string& folder) {
  namespace fs = std::filesystem;
  const Hidden made = hidden(request);
  writeCase(made.given, (fs::path{folder} / "cases" / request.name).string());
  const std::string path = (fs::path{folder} / "key.json").string();
  Keys keys = fs::exists(path) ? readKeys(path) : Keys{};
  keys[request.name] = made.key;
  writeKeys(keys, path);
}

}  // namespace darwinop::gap
