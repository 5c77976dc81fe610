#include "gap/benchmark/body/body_key.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "hal/text_file.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestKey = std::size_t{64} << 20;  // bytes

Json listOrOne(const std::vector<std::string>& words) {
  return words.size() == 1 ? Json(words.front()) : Json(words);
}

std::vector<std::string> wordsOf(const Json& json) {
  if (json.is_string()) return {json.get<std::string>()};
  return json.is_array() ? json.get<std::vector<std::string>>() : std::vector<std::string>{};
}

double jointsOf(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_object() ? found->value("joints_mrad", std::nan("")) : std::nan("");
}

Json jsonOf(const BodyKey& key) {
  Json effects = Json::array();
  for (const BodyKeyEffect& effect : key.effects) {
    Json params = Json::object();
    for (const auto& [name, values] : effect.values)
      params[name] = values.size() == 1 ? Json(values.front()) : Json(values);
    effects.push_back({{"id", effect.id}, {"at", listOrOne(effect.at)}, {"params", params}});
  }
  return {{"trust", key.is_exact ? "exact" : "wrong"},
          {"effects", effects},
          {"expected_verdict", key.is_outside        ? "unknown"
                               : key.effects.empty() ? "none"
                                                     : "named"},
          {"where", key.is_outside ? Json(key.where) : Json(nullptr)},
          {"gap_score", {{"joints_mrad", key.gap_mrad}}},
          {"noise_score", {{"joints_mrad", key.noise_mrad}}}};
}

BodyKey keyOf(const Json& json) {
  BodyKey key;
  key.is_exact = json.value("trust", "exact") == "exact";
  key.is_outside = json.value("expected_verdict", "") == "unknown";
  for (const Json& effect : json.at("effects")) key.effects.push_back(bodyKeyEffect(effect));
  if (const auto where = json.find("where"); where != json.end()) key.where = wordsOf(*where);
  key.gap_mrad = jointsOf(json, "gap_score"), key.noise_mrad = jointsOf(json, "noise_score");
  return key;
}

Json readJson(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path, kLongestKey);
  if (!text) throw std::runtime_error("cannot read " + path + "; the key is next to the folder of the cases");
  return Json::parse(*text);
}

}  // namespace

BodyKeyEffect bodyKeyEffect(const Json& json) {
  BodyKeyEffect out{.id = json.at("id"), .at = wordsOf(json.at("at")), .values = {}};
  const Json params = json.value("params", Json::object());
  for (const auto& [name, value] : params.items()) {
    if (value.is_number()) out.values[name] = {value.get<double>()};
    if (value.is_array() && std::ranges::all_of(value, [](const Json& number) { return number.is_number(); }))
      out.values[name] = value.get<std::vector<double>>();
  }
  return out;
}

void writeBodyKeys(const BodyKeys& keys, const std::string& path) {
  Json all = Json::object();
  for (const auto& [name, key] : keys) all[name] = jsonOf(key);
  writeTextFile(path, all.dump(1) + "\n");
}

BodyKeys readBodyKeys(const std::string& path) {
  BodyKeys keys;
  std::string name;
  try {
    const Json all = readJson(path);
    for (const auto& [case_name, json] : all.items()) {
      name = ", case " + case_name;
      keys[case_name] = keyOf(json);
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(path + name + ": " + error.what());
  }
  return keys;
}

bool isBodyKey(const std::string& path) try {
  const Json all = readJson(path);
  return all.is_object() && !all.empty() && all.front().is_object() && all.front().contains("expected_verdict");
} catch (const nlohmann::json::exception&) {
  return false;
}

}  // namespace darwinop::gap
