// The answer for a terminal and for programs.
#include <algorithm>
#include <cmath>

#include "core/text/formatted.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/identify/body/floor_text.hpp"
#include "gap/identify/body/held_out_text.hpp"
#include "gap/identify/body/mechanics_text.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using Object = nlohmann::ordered_json;

/// Values of one effect, and the half widths of their 90 % intervals; of a map without.
struct Values {
  std::vector<double> values, half_widths;
};

Values valuesOf(const SensorFit& fit, const SensorEffect& effect) {
  Values out;
  if (effect.number == SensorEffect::Number::kMap) {
    out.values.assign(fit.map.begin(), fit.map.end());
    return out;
  }
  Eigen::Index at = 0;
  for (const SensorEffect* const other : fit.effects) {
    if (other == &effect) break;
    if (other->number != SensorEffect::Number::kMap) at += 3;
  }
  for (Eigen::Index k = at; k < at + 3; ++k) {
    out.values.push_back(fit.values[k]);
    out.half_widths.push_back(thresholds::kInterval90 * fit.sigmas[k]);
  }
  return out;
}

std::string effectText(const SensorFit& fit, const SensorEffect& effect) {
  const Values of = valuesOf(fit, effect);
  std::string text = text::formatted("  %s at %s, %s", std::string{effect.id}.c_str(), std::string{effect.at}.c_str(),
                                     std::string{effect.parameter}.c_str());
  for (std::size_t k = 0; k < of.values.size(); ++k)
    text += of.half_widths.empty() ? text::formatted(" %.0f", of.values[k])
                                   : text::formatted(" %.4f +-%.4f", of.values[k], of.half_widths[k]);
  if (!effect.unit.empty()) text += " " + std::string{effect.unit};
  if (fit.maps_alike > 1)
    text += text::formatted("; %zu maps fit alike, clamp the trunk in other orientations", fit.maps_alike);
  return text + "\n";
}

std::string idsOf(const SensorFit& fit) {
  std::string ids;
  for (const SensorEffect* const effect : fit.effects) ids += (ids.empty() ? "" : " and ") + std::string{effect->id};
  return ids.empty() ? "no effect" : ids;
}

/// Every effect of the model and of its rivals, once.
Object alternativesOf(const SensorSelection& one) {
  std::vector<const SensorEffect*> effects = one.found.effects;
  for (const SensorFit& rival : one.rivals)
    for (const SensorEffect* const effect : rival.effects)
      if (std::ranges::find(effects, effect) == effects.end()) effects.push_back(effect);
  Object names = Object::array();
  for (const SensorEffect* const effect : effects) names.push_back({{"id", effect->id}, {"at", effect->at}});
  return names;
}

Object effectJson(const SensorFit& fit, const SensorEffect& effect) {
  const Values of = valuesOf(fit, effect);
  Object interval = Object::array();
  for (std::size_t k = 0; k < of.half_widths.size(); ++k)
    interval.push_back({of.values[k] - of.half_widths[k], of.values[k] + of.half_widths[k]});
  return {{"id", effect.id},
          {"at", effect.at},
          {"params", {{effect.parameter, of.values}}},
          {"interval_90", {{effect.parameter, interval}}}};
}

/// An effect of this block was found in this joint; or one in its limb, and its position is closed now. No effect of a
/// limb changes a supply.
bool isExplained(const MechanicsSelection& selection, const BodyRow& open) {
  const auto is_of_block = [&](const FoundMechanics& one) {
    const bool is_supply =
        !one.placed.effect->is_of_link && blockOf(twin::findEffect(one.placed.effect->id)->part) == Block::kSupply;
    return (open.block == Block::kSupply ? is_supply : one.is_in_controller) &&
           std::ranges::any_of(one.placed.joints, [&](Joint joint) { return row(joint).name == open.place.name; });
  };
  if (open.block != Block::kPlant && std::ranges::any_of(selection.found, is_of_block)) return true;
  const auto now =
      std::ranges::find(selection.rows, open.place.name, [](const BodyRow& one) { return one.place.name; });
  const bool is_touched =
      std::ranges::any_of(selection.touched, [&](Joint joint) { return row(joint).name == open.place.name; });
  return open.block != Block::kSupply && is_touched && now != selection.rows.end() && !now->open;
}

/// An effect on the floor was found, and this signal is closed now.
bool isExplained(const FloorSelection& selection, const std::string& signal) {
  const auto row = std::ranges::find(selection.rows_after, signal, &BodyRow::signal);
  return !selection.found.empty() && row != selection.rows_after.end() && !row->open;
}

/// Rows of the table that no named effect explains.
std::vector<const BodyRow*> unexplained(const BodyIdentification& found) {
  std::vector<const BodyRow*> rows;
  for (const BodyRow& row : found.table.rows) {
    if (!row.open) continue;
    // A block of a joint is explained where its limb is: load and position have one cause.
    bool is_explained = row.place.kind == Place::Kind::kJoint && isExplained(found.mechanics, row);
    if (row.place.kind == Place::Kind::kContact) is_explained = isExplained(found.floor, row.signal);
    for (const SensorSelection& one : found.sensors)
      if (row.place.name == name(one.sensor)) is_explained = !one.found.effects.empty() && !one.remains;
    if (!is_explained) rows.push_back(&row);
  }
  return rows;
}

std::string verdictText(const BodyIdentification& found) {
  switch (found.verdict) {
    case Verdict::kNamed:
      return "Named:\n";
    case Verdict::kAmbiguous:
      return "Ambiguous: these logs do not separate\n";
    case Verdict::kUnknown:
      return "Unknown: signals diverge, and no effect of the catalogue explains them\n";
    case Verdict::kNone:
      return "None: recordings and model agree\n";
    default:
      return "Cannot tell: what was tested agrees with the model, and not everything is tested\n";
  }
}

}  // namespace

std::string asText(const BodyIdentification& found) {
  std::string text = asText(found.table) + "\n" + verdictText(found);
  for (const SensorSelection& one : found.sensors) {
    for (const SensorEffect* const effect : one.found.effects) text += effectText(one.found, *effect);
    for (const SensorFit& rival : one.rivals)
      text += "  or " + idsOf(rival) +
              text::formatted(", behind by 1 to %.3g in odds\n", std::exp((one.found.evidence - rival.evidence) / 2));
  }
  if (found.battery) text += asText(*found.battery);
  text += asText(found.mechanics) + asText(found.floor) + asText(found.held_out);
  if (found.verdict == Verdict::kAmbiguous) text += "  " + std::string{kSeparatedByPlan} + "\n";
  for (const BodyRow* const row : unexplained(found))
    text += kNotExplained + row->signal + ", " + std::string{name(row->block)} + "\n";
  return text;
}

nlohmann::ordered_json asJson(const BodyCase& given, const BodyIdentification& found) {
  Object effects = Object::array(), candidates = effects, ambiguity = effects, where = effects;
  for (const SensorSelection& one : found.sensors) {
    for (const SensorEffect* const effect : one.found.effects) effects.push_back(effectJson(one.found, *effect));
    if (!one.rivals.empty()) ambiguity.push_back(alternativesOf(one));
  }
  if (found.battery) effects.push_back(effectJson(*found.battery));
  const std::vector<Limb> limbs = limbsOf(given.joints.model);
  for (const FoundMechanics& one : found.mechanics.found) {
    effects.push_back(effectJson(one, limbs));
    if (!one.rivals.empty()) ambiguity.push_back(alternativesOf(one));
  }
  for (const FoundFloor& one : found.floor.found) {
    effects.push_back(effectJson(one));
    if (!one.rivals.empty()) ambiguity.push_back(alternativesOf(one));
  }
  for (const PlacedMechanics& one : found.mechanics.tried)
    candidates.push_back(effectJson({.placed = one, .sigmas = {}, .rivals = {}}, limbs));
  for (const PlacedFloor& one : found.floor.tried)
    candidates.push_back(effectJson({.placed = one, .sigmas = {}, .rivals = {}}));
  for (const BodyRow& row : found.table.rows)
    if (row.open)
      where.push_back(
          {{"signal", row.signal}, {"file", row.file}, {"t0", row.t0_s}, {"t1", row.t1_s}, {"block", name(row.block)}});
  Object remainder = nullptr;
  if (found.verdict == Verdict::kNamed || found.verdict == Verdict::kAmbiguous) {
    Object signals = Object::array();
    for (const BodyRow* const row : unexplained(found)) signals.push_back(row->signal);
    if (!signals.empty()) remainder = {{"signals", signals}};
  }
  return {{"case", given.name},
          {"verdict", nameOf(found.verdict)},
          {"effects", effects},
          {"candidates", candidates},
          {"ambiguity", ambiguity},
          {"where", where},
          {"remainder", remainder},
          {"gap_score_before", asJson(found.held_out.before)},
          {"gap_score_after", asJson(found.held_out.after)},
          {"floor", asJson(found.held_out.floor)},
          {"not_tested", found.table.not_tested},
          {"runtime_s", found.runtime_s}};
}

}  // namespace darwinop::gap
