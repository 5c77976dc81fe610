#include "gap/benchmark/score/body/body_case_table.hpp"

#include <algorithm>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "gap/benchmark/score/body/graded_body.hpp"

namespace darwinop::gap {
namespace {

/// "link_com Body (shift 0 0.02 0)"
std::string described(const BodyKeyEffect& effect) {
  std::vector<std::string> numbers;
  for (const auto& [name, values] : effect.values) {
    std::string text = name;
    for (const double value : values) text += text::formatted(" %.3g", value);
    numbers.push_back(std::move(text));
  }
  std::string text = effect.id + " " + text::joined(effect.at, "+");
  return numbers.empty() ? text : text + " (" + text::joined(numbers, ", ") + ")";
}

std::string described(const std::vector<BodyKeyEffect>& effects) {
  std::vector<std::string> texts;
  for (const BodyKeyEffect& effect : effects) texts.push_back(described(effect));
  return text::joined(texts, "; ");
}

/// Names, the rivals of each, else the strongest signals.
std::string answered(const BodyAnswer& answer) {
  std::string text = described(answer.effects);
  for (const std::vector<PlacedName>& set : answer.ambiguity) {
    std::vector<std::string> names;
    for (const PlacedName& name : set) names.push_back(name.id + " " + text::joined(name.at, "+"));
    text += (text.empty() ? "" : "; ") + text::joined(names, " or ");
  }
  if (!text.empty() || answer.where.empty()) return text;
  constexpr std::size_t kShown = 3;
  return "at " +
         text::joined(std::vector(answer.where.begin(), answer.where.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                                   kShown, answer.where.size()))),
                      ", ");
}

}  // namespace

std::string bodyCaseTable(const BodyKeys& keys, const BodyAnswers& answers) {
  std::string text = "| case | hidden | verdict | answer | |\n|---|---|---|---|---|\n";
  for (const auto& [name, key] : keys) {
    const auto found = answers.find(name);
    const bool is_answered = found != answers.end();
    const GradedBody graded{key, countedAnswer(answers, name)};
    text += "| " + name + " | " + (key.effects.empty() ? graded.truth() : described(key.effects)) + " | " +
            (is_answered ? found->second.verdict : graded.answered()) + " | " +
            (is_answered ? answered(found->second) : "") + " | " + (graded.right() ? "" : "missed") + " |\n";
  }
  return text;
}

}  // namespace darwinop::gap
