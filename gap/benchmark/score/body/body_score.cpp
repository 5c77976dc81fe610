#include "gap/benchmark/score/body/body_score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "gap/benchmark/score/body/graded_body.hpp"

namespace darwinop::gap {
namespace {

// Steps of the registers of these cases.
constexpr double kGyroQuantum = 27.925 / 512, kAccelQuantum = 39.24 / 512;  // rad/s, m/s2
constexpr double kVisible = 2;  // noise floors from which a gap before counts as one that can shrink

/// "no row" counts where a kind of case has no second figure.
struct Tally {
  ShareFigure sensor{body_figures::kSensor, 0.98}, sensor_number{body_figures::kSensorNumber, 0.98};
  ShareFigure mass{body_figures::kMass, 0.9}, mass_number{body_figures::kMassNumber, 0.9};
  ShareFigure contact{body_figures::kContact, 0.9}, contact_number{body_figures::kContactNumber, 0.9};
  ShareFigure one{body_figures::kOneJoint, 0.9}, one_place{body_figures::kOneJointPlace, 0.98};
  ShareFigure many{body_figures::kManyJoints, 0.9}, many_place{body_figures::kManyJointsPlace, 0.9};
  ShareFigure bus{body_figures::kBus, 0.9}, bus_number{body_figures::kBusNumber, 0.9};
  ShareFigure both{body_figures::kTwoBoth, 0.75}, first{body_figures::kTwoFirst, 0.95};
  ShareFigure exact{body_figures::kExactAlarm, kNoTarget, 0.03}, wrong{body_figures::kWrongAlarm, kNoTarget, 0.1};
  ShareFigure false_name{body_figures::kFalseName};
  ShareFigure outside{body_figures::kOutside, 0.85}, outside_place{body_figures::kOutsidePlace, 0.8};
  SpreadFigure shrunk{figures::kGapOverBefore, "", 0.2, kNoTarget};
  SpreadFigure floors{figures::kGapOverFloor, "", 1.5, kNoTarget};
  SpreadFigure runtime{figures::kRuntime, "s", 90, 300, 1};

  void count(const GradedBody& graded) {
    if (!graded.key.effects.empty()) hidden(graded, graded.key.effects.front());
    const bool is_named = graded.answer != nullptr && !graded.answer->effects.empty();
    switch (graded.kind()) {
      case BodyKind::kTwo:
        both.count(std::ranges::all_of(graded.key.effects,
                                       [&](const BodyKeyEffect& one_of) { return graded.namesInPlace(one_of); }));
        first.count(graded.firstRight());
        break;
      case BodyKind::kExact:
        exact.count(graded.alarm()), false_name.count(is_named);
        break;
      case BodyKind::kWrong:
        wrong.count(graded.alarm()), false_name.count(is_named);
        break;
      case BodyKind::kOutside:
        outside.count(!is_named && graded.answer != nullptr), outside_place.count(graded.whereRight());
        break;
      default:
        break;
    }
    const BodyAnswer* const answer = graded.answer;
    if (answer == nullptr || graded.key.effects.empty() || graded.key.is_outside) return;
    if (answer->before_mrad > kVisible * answer->floor_mrad)
      shrunk.values.push_back(answer->after_mrad / answer->before_mrad);
    if (answer->after_mrad > 0) floors.values.push_back(answer->after_mrad / answer->floor_mrad);
  }

  void hidden(const GradedBody& graded, const BodyKeyEffect& effect) {
    const auto number = [&](ShareFigure& figure, double share, double absolute) {
      if (graded.namesInPlace(effect)) figure.count(graded.numbersWithin(effect, share, absolute));
    };
    switch (graded.kind()) {
      case BodyKind::kSensor:
        sensor.count(graded.namesInPlace(effect));
        number(sensor_number, 0.05,
               !effect.id.ends_with("_bias") ? 0 : 3 * (effect.id.starts_with("gyro") ? kGyroQuantum : kAccelQuantum));
        break;
      case BodyKind::kMass:
        mass.count(graded.namesOrDoubts(effect)), number(mass_number, 0.1, 0);
        break;
      case BodyKind::kContact:
        contact.count(graded.names(effect)), number(contact_number, 0.2, 0);
        break;
      case BodyKind::kOneJoint:
        one.count(graded.names(effect)), one_place.count(graded.placeRight(effect));
        break;
      case BodyKind::kManyJoints:
        many.count(graded.names(effect)), many_place.count(graded.placeRight(effect));
        break;
      case BodyKind::kBus:
        bus.count(graded.names(effect)), number(bus_number, 0.1, 0);
        break;
      default:
        break;
    }
  }
};

CaseClass classOf(const GradedBody& graded) {
  if (graded.key.is_outside) return CaseClass::kOutside;
  return graded.key.effects.empty()       ? CaseClass::kEffectFree
         : graded.key.effects.size() == 1 ? CaseClass::kSingle
                                          : CaseClass::kDouble;
}

}  // namespace

Score bodyScoreOf(const BodyKeys& keys, const BodyAnswers& answers) {
  Score score;
  Tally tally;
  std::map<std::tuple<CaseClass, std::string, std::string>, std::vector<std::string>> confusions;
  for (const auto& [name, key] : keys) {
    const auto found = answers.find(name);
    const GradedBody graded{key, countedAnswer(answers, name)};
    ++score.cases;
    tally.count(graded);
    score.fair.count(graded.right());
    if (found != answers.end() && std::isfinite(found->second.runtime_s))
      tally.runtime.values.push_back(found->second.runtime_s);
    if (graded.answer == nullptr) score.unanswered.push_back(name);
    if (!graded.right()) confusions[{classOf(graded), graded.truth(), graded.answered()}].push_back(name);
  }
  for (const auto& [name, answer] : answers)
    if (!keys.contains(name)) score.without_key.push_back(name);
  score.shares = {tally.sensor,     tally.sensor_number,  tally.mass,         tally.mass_number,
                  tally.contact,    tally.contact_number, tally.one,          tally.one_place,
                  tally.many,       tally.many_place,     tally.bus,          tally.bus_number,
                  tally.both,       tally.first,          tally.exact,        tally.wrong,
                  tally.false_name, tally.outside,        tally.outside_place};
  std::erase_if(score.shares, [](const ShareFigure& figure) { return figure.of == 0; });
  score.spreads = {tally.shrunk, tally.floors, tally.runtime};
  for (auto& [what, cases] : confusions)
    score.confusions.push_back({std::get<0>(what), std::get<1>(what), std::get<2>(what), std::move(cases)});
  return score;
}

}  // namespace darwinop::gap
