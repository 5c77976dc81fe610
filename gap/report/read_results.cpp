#include "gap/report/read_results.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "gap/report/data_hash.hpp"
#include "gap/report/messages.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

const json& resultOf(const json& all, const std::string& name) {
  if (all.is_object()) return all;
  for (const json& one : all)
    if (one.value("case", "") == name) return one;
  throw std::runtime_error("has no result of case " + name);
}

void checkCase(const json& result, const std::string& name) {
  const std::string of = result.at("case");
  if (of != name) throw std::runtime_error("is of case " + of + ", not of " + name);
}

/// Throws for a verdict without an effect.
void checkVerdict(const json& result, const std::string& name) {
  checkCase(result, name);
  const std::string verdict = result.at("verdict");
  if (verdict == "none") throw std::runtime_error("nothing is missing by this result: there is nothing to add");
  if (verdict != "named" && verdict != "ambiguous")
    throw std::runtime_error("has the verdict " + verdict + ", which " + messages::kNamesNoEffect +
                             "; to add one anyway, give it with --effect");
  if (result.at("effects").empty())
    throw std::runtime_error(std::string{messages::kNamesNoEffect} + ": there is nothing to add");
}

AddedEffect effectIn(const json& from, const json& result) {
  AddedEffect effect{.id = from.at("id"), .values = {}, .because = {}};
  const json intervals = from.value("interval_90", json::object());
  const json& values = from.contains("in_model") ? from["in_model"] : from.at("params");
  for (const auto& [key, value] : values.items()) {
    AddedValue added{key, value.get<double>(), std::nan(""), std::nan("")};
    if (intervals.contains(key) && intervals[key].size() == 2 && intervals[key][0].is_number() &&
        intervals[key][1].is_number())
      added.setInterval(intervals[key][0], intervals[key][1],
                        added.value - from.value("params", json::object()).value(key, added.value));
    effect.values.push_back(added);
  }
  if (from.contains("because"))
    effect.because = from["because"].get<std::vector<std::string>>();
  else
    effect.because = {"Found by darwinop gap in case " + result.at("case").get<std::string>() + ", verdict " +
                      result.at("verdict").get<std::string>()};
  return effect;
}

Verdict verdictNamed(const std::string& name) {
  for (const Verdict one :
       {Verdict::kNone, Verdict::kNamed, Verdict::kAmbiguous, Verdict::kUnknown, Verdict::kCannotTell})
    if (nameOf(one) == name) return one;
  throw std::runtime_error("has the verdict " + name + ", which leaves nothing to plan");
}

/// `read` of the result of this case in `text`. Throws std::runtime_error with the file and a sentence.
template <class Read>
auto inResult(std::string_view text, const std::string& file, const Case& given, const Read& read) {
  try {
    const json all = json::parse(text);
    return read(resultOf(all, given.name));
  } catch (const json::exception& error) {
    throw std::runtime_error(file + ": " + messages::kNotAResult + " (" + error.what() +
                             "); `darwinop gap run` writes report.json, `darwinop gap benchmark run` results.json");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

}  // namespace

Additions additionsIn(std::string_view results, const std::string& file, const Case& given) {
  return inResult(results, file, given, [&](const json& result) {
    checkVerdict(result, given.name);
    Additions additions;
    for (const json& effect : result.at("effects")) additions.effects.push_back(effectIn(effect, result));
    for (const json& moved : result.value("moved", json::array())) additions.effects.push_back(effectIn(moved, result));
    for (const json& number : result.value("numbers", json::array()))
      additions.numbers.push_back({number.at("number"), number.at("after")});
    return atJoint(std::move(additions), given);
  });
}

Identification identifiedIn(std::string_view report, const std::string& file, const Case& given) {
  return inResult(report, file, given, [&](const json& result) {
    checkCase(result, given.name);
    Identification found;
    found.verdict = verdictNamed(result.at("verdict"));
    for (const json& effect : result.at("effects")) {
      const std::string id = effect.at("id");
      const twin::EffectInfo* const known = twin::findEffect(id);
      if (known == nullptr) throw std::runtime_error("has the effect " + id + ", which the catalogue does not have");
      found.effects.push_back({known, {}, 0});
    }
    if (!result.contains("rivals")) throw std::runtime_error(messages::kNoRivals);
    for (const json& rival : result["rivals"])
      found.rivals.push_back({rival.at("effects").get<std::vector<std::string>>(), rival.at("behind"), false});
    return found;
  });
}

std::string otherDataWarning(std::string_view results, const std::string& file, const std::string& data_hash) {
  const json all = json::parse(results);
  const bool is_other = all.is_object() && !data_hash.empty() && all.value(kDataHash, data_hash) != data_hash;
  return is_other ? file + messages::kOtherData : "";
}

}  // namespace darwinop::gap
