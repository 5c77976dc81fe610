#include "gap/benchmark/score/body/body_answers.hpp"

#include <cmath>

#include "gap/benchmark/score/results_file.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

double jointsOf(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_object() ? numberIn(*found, "joints_mrad") : std::nan("");
}

BodyAnswer answerOf(const Json& json) {
  BodyAnswer out;
  out.verdict = json.at("verdict");
  const Json none = Json::array();
  const Json effects = json.value("effects", none), sets = json.value("ambiguity", none),
             where = json.value("where", none);
  for (const Json& effect : effects) out.effects.push_back(bodyKeyEffect(effect));
  for (const Json& set : sets) {
    std::vector<PlacedName>& names = out.ambiguity.emplace_back();
    for (const Json& one : set) {
      const BodyKeyEffect effect = bodyKeyEffect(one);
      names.push_back({effect.id, effect.at});
    }
  }
  for (const Json& row : where) out.where.push_back(row.at("signal"));
  out.before_mrad = jointsOf(json, "gap_score_before");
  out.after_mrad = jointsOf(json, "gap_score_after");
  out.floor_mrad = jointsOf(json, "floor");
  out.runtime_s = numberIn(json, "runtime_s");
  return out;
}

}  // namespace

const BodyAnswer* countedAnswer(const BodyAnswers& answers, const std::string& name) {
  const auto found = answers.find(name);
  if (found == answers.end() || found->second.runtime_s > kBodyTooLate || found->second.verdict == "error")
    return nullptr;
  return &found->second;
}

BodyAnswers readBodyAnswers(const std::string& path) {
  BodyAnswers answers;
  forEachResult(path, [&](const std::string& name, const Json& result) { answers[name] = answerOf(result); });
  return answers;
}

}  // namespace darwinop::gap
