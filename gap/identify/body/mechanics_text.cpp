#include "gap/identify/body/mechanics_text.hpp"

#include <algorithm>

#include "core/text/formatted.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

using Object = nlohmann::ordered_json;

std::string nameOf(Joint joint) {
  return std::string{row(joint).name};
}

/// A number of an answer: a vector has its three as one.
struct Quantity {
  std::string key, unit;
  std::vector<double> values, sigmas;
};

/// The total, where it is the same in all joints.
bool hasTotal(const FoundMechanics& one) {
  return !one.own.empty() && std::ranges::all_of(one.own, [&](double own) { return own == one.own.front(); });
}

/// `com`: of the link, where it is known: the place of a mass is then in the link's frame, else from its centre of
/// mass.
std::vector<Quantity> quantitiesOf(const FoundMechanics& one, const Eigen::Vector3d& com) {
  std::vector<Quantity> out;
  const auto& numbers = one.placed.effect->numbers;
  const bool is_mass = one.placed.effect->id == "link_mass";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    double sigma = i < one.sigmas.size() ? one.sigmas[i] : 0;
    if (sigma > numbers[i].high - numbers[i].low) sigma = 0;  // the logs do not show it
    if (numbers[i].is_addition) {
      const double added = one.placed.values[i];
      const double shown = hasTotal(one) ? std::max(0.0, one.own.front() + added) : added;
      out.push_back({std::string{numbers[i].key}, std::string{numbers[i].unit}, {shown}, {sigma}});
      out.push_back({std::string{numbers[i].key} + std::string{kAddedEnding}, "", {added}, {sigma}});
      continue;
    }
    if (!one.placed.effect->is_of_link || numbers[i].unit != "m") {
      out.push_back({std::string{numbers[i].key}, std::string{numbers[i].unit}, {one.placed.values[i]}, {sigma}});
      continue;
    }
    if (numbers[i].key == "x") out.push_back({is_mass ? "point" : "shift", "m", {}, {}});
    const auto axis = static_cast<Eigen::Index>(out.back().values.size());
    out.back().values.push_back(one.placed.values[i] + (is_mass ? com[axis] : 0));
    out.back().sigmas.push_back(sigma);
  }
  return out;
}

Object listOrNumber(const std::vector<double>& values) {
  return values.size() == 1 ? Object(values.front()) : Object(values);
}

}  // namespace

std::string placesText(const std::vector<Joint>& joints) {
  if (joints.size() == kJoints) return "all joints";
  std::string text;
  for (const Joint joint : joints) text += (text.empty() ? "" : " and ") + nameOf(joint);
  return text;
}

Object placesJson(const std::vector<Joint>& joints) {
  if (joints.size() == kJoints) return "all";
  if (joints.size() == 1) return nameOf(joints.front());
  Object out = Object::array();
  for (const Joint joint : joints) out.push_back(nameOf(joint));
  return out;
}

std::string asText(const MechanicsSelection& selection) {
  std::string text;
  for (const FoundMechanics& one : selection.found) {
    text += text::formatted("  %s at %s", std::string{one.placed.effect->id}.c_str(),
                            placesText(one.placed.joints).c_str());
    for (const Quantity& of : quantitiesOf(one, Eigen::Vector3d::Zero())) {
      if (of.key.ends_with(kAddedEnding)) continue;  // for programs
      const bool is_added = !one.own.empty() && !hasTotal(one);
      text += std::string{is_added ? ", added " : ", "} + (of.key == "point" ? "from its centre of mass" : of.key);
      for (std::size_t i = 0; i < of.values.size(); ++i)
        text += text::formatted(of.sigmas[i] > 0 ? " %.4g +-%.2g" : " %.4g", of.values[i],
                                thresholds::kInterval90 * of.sigmas[i]);
      if (!of.unit.empty()) text += " " + of.unit;
    }
    text += "\n";
    for (const PlacedMechanics& rival : one.rivals)
      text += "  or " + std::string{rival.effect->id} + " at " + placesText(rival.joints) + "\n";
  }
  for (const PlacedMechanics& one : selection.tried)
    text += "  not named, as a log contradicts it or it leaves too much: " + std::string{one.effect->id} + " at " +
            placesText(one.joints) + "\n";
  return text;
}

Object effectJson(const FoundMechanics& one, const std::vector<Limb>& limbs) {
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  for (const Limb& limb : limbs)
    for (const Link& link : limb)
      if (link.joint == one.placed.joints.front()) com = link.com_m;
  Object params = Object::object(), interval = Object::object();
  for (const Quantity& of : quantitiesOf(one, com)) {
    params[of.key] = listOrNumber(of.values);
    if (of.sigmas.front() == 0) continue;
    Object ends = Object::array();
    for (std::size_t i = 0; i < of.values.size(); ++i) {
      const double half = thresholds::kInterval90 * of.sigmas[i];
      ends.push_back({of.values[i] - half, of.values[i] + half});
    }
    interval[of.key] = of.values.size() == 1 ? ends.front() : ends;
  }
  return {{"id", one.placed.effect->id},
          {"at", placesJson(one.placed.joints)},
          {"params", params},
          {"interval_90", interval}};
}

Object alternativesOf(const FoundMechanics& one) {
  Object out = Object::array();
  out.push_back({{"id", one.placed.effect->id}, {"at", placesJson(one.placed.joints)}});
  for (const PlacedMechanics& rival : one.rivals)
    out.push_back({{"id", rival.effect->id}, {"at", placesJson(rival.joints)}});
  return out;
}

}  // namespace darwinop::gap
