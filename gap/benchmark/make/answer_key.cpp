#include "gap/benchmark/make/answer_key.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "hal/text_file.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestKey = std::size_t{64} << 20;  // bytes

// In the order of CaseClass.
constexpr std::array<std::string_view, 4> kClasses{"single", "control", "double", "uncatalogued"};

double inMrad(double rad) {
  return std::round(rad * 1e6) / 1e3;
}

Json jsonOf(const Key& key) {
  Json effects = Json::array(), expected = Json::array(), places = Json::array();
  for (const KeyEffect& effect : key.effects) {
    effects.push_back({{"id", effect.id},
                       {"severity", effect.severity > 0 ? Json(effect.severity) : Json(nullptr)},
                       {"params", effect.values}});
    expected.push_back(effect.id);
  }
  if (key.kind == CaseClass::kEffectFree) expected = "no missing effect";
  if (key.kind == CaseClass::kOutside) expected = "unknown";
  for (const KeyPlace& place : key.places)
    places.push_back({{"file", place.file}, {"t0", place.from_s}, {"t1", place.to_s}});
  return {{"family", key.family},
          {"cls", kClasses[static_cast<std::size_t>(key.kind)]},
          {"tier", key.exact ? "exact" : "nuisance"},
          {"baseline", key.baseline},
          {"effects", effects},
          {"expected", expected},
          {"nuisance_factors", key.number_factors},
          {"gap_fit_mrad", inMrad(key.gap_fit_rad)},
          {"gap_score_mrad", inMrad(key.gap_held_out_rad)},
          {"noise_fit_mrad", inMrad(key.noise_fit_rad)},
          {"noise_score_mrad", inMrad(key.noise_held_out_rad)},
          {"where", places}};
}

std::map<std::string, double> numbersOf(const Json& json) {
  std::map<std::string, double> out;
  for (const auto& [name, value] : json.items())
    if (value.is_number()) out[name] = value.get<double>();  // "_kp": a note for people
  return out;
}

double radOf(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number() ? found->get<double>() / 1e3
                                                   : std::numeric_limits<double>::quiet_NaN();
}

Key keyOf(const Json& json) {
  Key key;
  const std::string cls = json.at("cls");
  const auto found = std::ranges::find(kClasses, cls);
  if (found == kClasses.end())
    throw std::runtime_error("`cls` is " + cls + "; there are single, control, double and uncatalogued");
  key.kind = static_cast<CaseClass>(found - kClasses.begin());
  key.family = json.value("family", "");
  key.exact = json.value("tier", "exact") == "exact";
  key.baseline = json.value("baseline", "");
  for (const Json& effect : json.at("effects")) {
    const auto severity = effect.find("severity");
    key.effects.push_back({effect.at("id"),
                           severity != effect.end() && severity->is_number() ? severity->get<int>() : 0,
                           numbersOf(effect.value("params", Json::object()))});
  }
  key.number_factors = numbersOf(json.value("nuisance_factors", Json::object()));
  key.gap_fit_rad = radOf(json, "gap_fit_mrad");
  key.gap_held_out_rad = radOf(json, "gap_score_mrad");
  key.noise_fit_rad = radOf(json, "noise_fit_mrad");
  key.noise_held_out_rad = radOf(json, "noise_score_mrad");
  for (const Json& place : json.value("where", Json::array()))
    key.places.push_back({place.at("file"), place.at("t0"), place.at("t1")});
  return key;
}

}  // namespace

void writeKeys(const Keys& keys, const std::string& path) {
  Json all = Json::object();
  for (const auto& [name, key] : keys) all[name] = jsonOf(key);
  writeTextFile(path, all.dump(1) + "\n");
}

Keys readKeys(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path, kLongestKey);
  if (!text) throw std::runtime_error("cannot read " + path + "; the key is next to the folder of the cases");
  Keys keys;
  std::string name;
  try {
    const Json all = Json::parse(*text);
    for (const auto& [case_name, json] : all.items()) {
      name = ", case " + case_name;
      keys[case_name] = keyOf(json);
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(path + name + ": " + error.what());
  }
  return keys;
}

}  // namespace darwinop::gap
