#include "gap/benchmark/score/score.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "gap/benchmark/score/graded_case.hpp"
#include "gap/benchmark/score/parameter_names.hpp"

namespace darwinop::gap {
namespace {

/// By severity (0: none was given) and wrong numbers; of effect-free cases by exact numbers.
struct Details {
  std::map<std::pair<int, bool>, ShareFigure> named, honest;
  std::map<bool, ShareFigure> alarms;

  [[nodiscard]] std::vector<ShareFigure> inWords() const {
    std::vector<ShareFigure> out;
    for (const auto* const figures : {&named, &honest})
      for (const auto& [key, figure] : *figures) {
        out.push_back(figure);
        out.back().what = (key.first > 0 ? "severity " + std::to_string(key.first) : "severity not given") +
                          (key.second ? ", wrong numbers: " : ", exact numbers: ") +
                          (figures == &named ? "named first" : "or ambiguous");
      }
    for (const auto& [exact, figure] : alarms) {
      out.push_back(figure);
      out.back().what = std::string{"effect-free, "} + (exact ? "exact" : "wrong") + " numbers: false alarm";
    }
    return out;
  }
};

/// All figures while they are counted.
struct Tally {
  ShareFigure strong{figures::kExactNumbers, 0.97};
  ShareFigure wrong{figures::kWrongNumbers, 0.85};
  ShareFigure weak{figures::kWeak, 0.82};
  ShareFigure honest{figures::kHonest, 0.95};
  ShareFigure interval{figures::kInterval, 0.8, 0.97};
  ShareFigure alarm{figures::kFalseAlarm, kNoTarget, 0.04};
  ShareFigure both{figures::kBothOfTwo, 0.8};
  ShareFigure first{figures::kFirstOfTwo, 0.98};
  ShareFigure unknown{figures::kOutsideUnknown, 0.85};
  ShareFigure mistaken{figures::kOutsideNamed, kNoTarget, 0.15};
  ShareFigure block{figures::kBlock, 0.95};
  ShareFigure first_open_block{figures::kFirstOpenBlock};
  SpreadFigure error{figures::kParameterError, "%", 3, 15};
  SpreadFigure floors{figures::kGapOverFloor, "", 1.3, 3};
  SpreadFigure shrunk{figures::kGapOverBefore, "", 0.15, kNoTarget};
  SpreadFigure runtime{figures::kRuntime, "s", 30, 120, 1};

  ShareFigure fair;
  Details details;

  void single(const GradedCase& graded) {
    const int severity = graded.key.effects.empty() ? 0 : graded.key.effects.front().severity;
    ShareFigure* const figure = severity == 1                       ? &weak
                                : severity >= 2 && graded.key.exact ? &strong
                                : severity == 2                     ? &wrong
                                                                    : nullptr;
    if (figure == nullptr) return;
    figure->count(graded.namedFirst());
    honest.count(graded.honest());
  }

  void detail(const GradedCase& graded) {
    const bool exact = graded.key.exact;
    if (graded.key.kind == CaseClass::kEffectFree) details.alarms[exact].count(graded.alarm());
    if (graded.key.kind != CaseClass::kSingle || graded.key.effects.empty()) return;
    const std::pair key{graded.key.effects.front().severity, !exact};
    details.named[key].count(graded.namedFirst());
    details.honest[key].count(graded.honest());
  }

  void parameters(const GradedCase& graded) {
    if (!graded.hasVerdict("named")) return;
    for (const KeyEffect& hidden : graded.key.effects) {
      const auto found = std::ranges::find(graded.answer->effects, hidden.id, &AnswerEffect::id);
      if (found != graded.answer->effects.end()) compare(hidden, *found);
    }
  }
  void compare(const KeyEffect& hidden, const AnswerEffect& estimate) {
    const auto truths = inCatalogueNames(hidden.id, hidden.values);
    for (const auto& [key, value] : inCatalogueNames(hidden.id, estimate.values)) {
      const auto truth = truths.find(key);
      if (truth == truths.end()) continue;
      if (const auto off = relativeError(hidden.id, key, value, truth->second)) error.values.push_back(100 * *off);
    }
    for (const auto& [name, ends] : estimate.intervals) {
      const auto parameter = parameterOf(hidden.id, name);
      const auto truth = parameter ? truths.find(std::string{parameter->key}) : truths.end();
      if (truth == truths.end() || errorScaleOf(hidden.id, parameter->key) == twin::ErrorScale::kNone) continue;
      const double value = truth->second + parameter->zero;
      interval.count(value >= ends.first && value <= ends.second);
    }
  }

  void gaps(const GradedCase& graded) {
    if (graded.answer == nullptr || !std::isfinite(graded.answer->after_rad)) return;
    if (graded.key.noise_held_out_rad > 0)
      floors.values.push_back(graded.answer->after_rad / graded.key.noise_held_out_rad);
    if (graded.answer->before_rad > 0) shrunk.values.push_back(graded.answer->after_rad / graded.answer->before_rad);
  }

  void count(const GradedCase& graded) {
    fair.count(graded.fair());
    detail(graded);
    switch (graded.key.kind) {
      case CaseClass::kSingle:
        single(graded);
        break;
      case CaseClass::kEffectFree:
        alarm.count(graded.alarm());
        break;
      case CaseClass::kDouble:
        both.count(graded.namedAll());
        first.count(graded.firstRight());
        break;
      case CaseClass::kOutside:
        unknown.count(graded.right());
        mistaken.count(graded.answer != nullptr && !graded.answer->effects.empty());
        break;
    }
    if (graded.key.kind == CaseClass::kSingle || graded.key.kind == CaseClass::kDouble) {
      parameters(graded);
      gaps(graded);
    }
  }
};

bool namesBlocks(const Answers& answers) {
  return std::ranges::any_of(answers, [](const auto& answer) {
    if (!answer.second.block.empty()) return true;
    return std::ranges::any_of(answer.second.places, [](const AnswerPlace& place) { return !place.block.empty(); });
  });
}

}  // namespace

Score scoreOf(const Keys& keys, const Answers& answers) {
  Score score;
  Tally tally;
  std::map<std::tuple<CaseClass, std::string, std::string>, std::vector<std::string>> confusions;
  const bool blocks = namesBlocks(answers);
  const bool first_open_block =
      std::ranges::any_of(answers, [](const auto& answer) { return !answer.second.first_open_block.empty(); });
  for (const auto& [name, key] : keys) {
    const auto found = answers.find(name);
    const bool counts =
        found != answers.end() && !(found->second.runtime_s > kTooLate) && found->second.verdict != "error";
    const GradedCase graded{key, counts ? &found->second : nullptr};
    ++score.cases;
    tally.count(graded);
    if (found != answers.end() && std::isfinite(found->second.runtime_s))
      tally.runtime.values.push_back(found->second.runtime_s);
    if (blocks && !key.effects.empty()) tally.block.count(graded.rightBlock());
    if (first_open_block && !key.effects.empty()) tally.first_open_block.count(graded.firstOpenBlockRight());
    if (graded.answer == nullptr) score.unanswered.push_back(name);
    if (!graded.right()) confusions[{key.kind, graded.truth(), graded.answered()}].push_back(name);
  }
  for (const auto& [name, answer] : answers)
    if (!keys.contains(name)) score.without_key.push_back(name);
  score.shares = {tally.strong, tally.wrong, tally.weak,    tally.honest,   tally.interval, tally.alarm,
                  tally.both,   tally.first, tally.unknown, tally.mistaken, tally.block,    tally.first_open_block};
  score.spreads = {tally.error, tally.floors, tally.shrunk, tally.runtime};
  score.fair.right = tally.fair.right;
  score.fair.of = tally.fair.of;
  score.details = tally.details.inWords();
  for (auto& [what, cases] : confusions)
    score.confusions.push_back({std::get<0>(what), std::get<1>(what), std::get<2>(what), std::move(cases)});
  std::ranges::stable_sort(score.confusions, [](const Confusion& a, const Confusion& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.cases.size() > b.cases.size();
  });
  return score;
}

}  // namespace darwinop::gap
