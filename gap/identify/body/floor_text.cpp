#include "gap/identify/body/floor_text.hpp"

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "core/units.hpp"
#include "gap/identify/body/floor_candidates.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Numbers with one key are one vector.
struct FloorQuantity {
  std::string key, unit;
  std::vector<double> values, half_widths;
};

std::vector<FloorQuantity> quantitiesOf(const FoundFloor& one) {
  std::vector<FloorQuantity> out;
  for (std::size_t i = 0; i < one.placed.values.size(); ++i) {
    const FloorEffect::Number& number = one.placed.effect->numbers[i];
    if (out.empty() || out.back().key != number.key)
      out.push_back({std::string{number.key}, std::string{number.unit}, {}, {}});
    out.back().values.push_back(one.placed.values[i] + number.shown_offset);
    if (i < one.sigmas.size() && one.sigmas[i] > 0)
      out.back().half_widths.push_back(thresholds::kInterval90 * one.sigmas[i]);
  }
  return out;
}

std::string placeText(const FloorEffect& effect) {
  return std::string{effect.id} + " at " + text::joined(loadedJointsAt(effect.at), " and ");
}

std::string effectText(const FoundFloor& one) {
  std::string text = placeText(*one.placed.effect);
  for (const FloorQuantity& of : quantitiesOf(one)) {
    text += ", " + of.key;
    for (std::size_t i = 0; i < of.values.size(); ++i) {
      text += text::formatted(" %.4g", of.values[i]);
      if (i < of.half_widths.size()) text += text::formatted(" +-%.2g", of.half_widths[i]);
    }
    if (!of.unit.empty()) text += " " + of.unit;
  }
  return text + "\n";
}

nlohmann::ordered_json nameJson(const FloorEffect& effect) {
  const std::vector<std::string_view> at = loadedJointsAt(effect.at);
  nlohmann::ordered_json out{{"id", effect.id}, {"at", effect.at}};
  if (at.size() > 1) out["at"] = at;
  return out;
}

}  // namespace

std::string asText(const FloorSelection& selection) {
  std::string text;
  for (const FoundFloor& one : selection.found) {
    text += "  " + effectText(one);
    for (const PlacedFloor& rival : one.rivals) text += "  or " + placeText(*rival.effect) + "\n";
  }
  for (const PlacedFloor& one : selection.tried)
    text += kNotNamed + effectText({.placed = one, .sigmas = {}, .rivals = {}});
  return text;
}

nlohmann::ordered_json effectJson(const FoundFloor& one) {
  nlohmann::ordered_json params = nlohmann::ordered_json::object(), interval = params;
  for (const FloorQuantity& of : quantitiesOf(one)) {
    const bool is_number = of.values.size() == 1;
    params[of.key] = is_number ? nlohmann::ordered_json(of.values.front()) : nlohmann::ordered_json(of.values);
    if (of.half_widths.size() != of.values.size()) continue;
    nlohmann::ordered_json ends = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < of.values.size(); ++i)
      ends.push_back({of.values[i] - of.half_widths[i], of.values[i] + of.half_widths[i]});
    interval[of.key] = is_number ? ends.front() : ends;
  }
  nlohmann::ordered_json out = nameJson(*one.placed.effect);
  out["params"] = params;
  out["interval_90"] = interval;
  return out;
}

nlohmann::ordered_json alternativesOf(const FoundFloor& one) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  out.push_back(nameJson(*one.placed.effect));
  for (const PlacedFloor& rival : one.rivals) out.push_back(nameJson(*rival.effect));
  return out;
}

}  // namespace darwinop::gap
