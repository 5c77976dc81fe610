#include "gap/benchmark/score/answers.hpp"

#include <nlohmann/json.hpp>

#include "gap/benchmark/score/results_file.hpp"

namespace darwinop::gap {
namespace {

using Json = nlohmann::ordered_json;

/// Empty where there is none, or null.
std::string wordOf(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

AnswerEffect effectOf(const Json& json) {
  AnswerEffect effect{json.at("id"), {}, {}};
  const Json params = json.value("params", Json::object()), intervals = json.value("interval_90", Json::object());
  for (const auto& [name, value] : params.items())
    if (value.is_number()) effect.values[name] = value.get<double>();
  for (const auto& [name, value] : intervals.items())
    if (value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number())
      effect.intervals[name] = {value[0].get<double>(), value[1].get<double>()};
  return effect;
}

CaseAnswer answerOf(const Json& json) {
  CaseAnswer answer;
  answer.verdict = json.at("verdict");
  for (const Json& effect : json.value("effects", Json::array())) answer.effects.push_back(effectOf(effect));
  for (const Json& set : json.value("ambiguity", Json::array()))
    answer.ambiguity.push_back(set.get<std::vector<std::string>>());
  for (const Json& place : json.value("where", Json::array()))
    answer.places.push_back(
        {wordOf(place, "file"), numberIn(place, "t0"), numberIn(place, "t1"), wordOf(place, "block")});
  answer.block = wordOf(json, "block");
  answer.first_open_block = wordOf(json, json.contains("first_open_block") ? "first_open_block" : "opens");
  answer.before_rad = numberIn(json, "gap_score_before_mrad") / 1e3;
  answer.after_rad = numberIn(json, "gap_score_after_mrad") / 1e3;
  answer.runtime_s = numberIn(json, "runtime_s");
  return answer;
}

}  // namespace

Answers readAnswers(const std::string& path) {
  Answers answers;
  forEachResult(path, [&](const std::string& name, const Json& result) { answers[name] = answerOf(result); });
  return answers;
}

}  // namespace darwinop::gap
