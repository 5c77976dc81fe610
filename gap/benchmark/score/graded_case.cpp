#include "gap/benchmark/score/graded_case.hpp"

#include <algorithm>

#include "gap/plant/block.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kLargestSet = 3;  // effects that an honest ambiguity may have
constexpr std::size_t kPlaces = 3;      // of an answer that are looked at

std::string listed(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

template <class List>
std::string idsOf(const List& effects) {
  std::vector<std::string> ids;
  ids.reserve(effects.size());
  for (const auto& effect : effects) ids.push_back(effect.id);
  return listed(ids, " + ");
}

}  // namespace

bool GradedCase::hasVerdict(std::string_view verdict) const {
  return answer != nullptr && answer->verdict == verdict;
}

bool GradedCase::hides(const std::string& id) const {
  return std::ranges::find(key.effects, id, &KeyEffect::id) != key.effects.end();
}

bool GradedCase::firstRight() const {
  return answer != nullptr && !answer->effects.empty() && hides(answer->effects.front().id);
}

bool GradedCase::namedFirst() const {
  return hasVerdict("named") && firstRight();
}

bool GradedCase::namedAll() const {
  if (!hasVerdict("named") || answer->effects.size() != key.effects.size()) return false;
  return std::ranges::all_of(key.effects, [&](const KeyEffect& hidden) {
    return std::ranges::find(answer->effects, hidden.id, &AnswerEffect::id) != answer->effects.end();
  });
}

bool GradedCase::honest() const {
  if (namedFirst()) return true;
  return hasVerdict("ambiguous") && std::ranges::any_of(answer->ambiguity, [&](const std::vector<std::string>& set) {
           return set.size() <= kLargestSet && std::ranges::any_of(set, [&](const auto& id) { return hides(id); });
         });
}

bool GradedCase::namesNothingFalse() const {
  return answer != nullptr && std::ranges::all_of(answer->effects, [&](const AnswerEffect& named) {
           return hides(named.id) || std::ranges::any_of(answer->ambiguity, [&](const std::vector<std::string>& set) {
                    return std::ranges::find(set, named.id) != set.end();
                  });
         });
}

bool GradedCase::alarm() const {
  return answer == nullptr || hasVerdict("named") || hasVerdict("ambiguous") || hasVerdict("unknown") ||
         hasVerdict("bad_input");
}

bool GradedCase::rightPlace() const {
  if (key.places.empty()) return true;
  if (answer == nullptr) return false;
  for (std::size_t i = 0; i < std::min(kPlaces, answer->places.size()); ++i)
    for (const KeyPlace& place : key.places) {
      const AnswerPlace& found = answer->places[i];
      if (found.file == place.file && found.from_s <= place.to_s && found.to_s >= place.from_s) return true;
    }
  return false;
}

bool GradedCase::acts(std::string_view block) const {
  return std::ranges::any_of(key.effects, [&](const KeyEffect& effect) {
    const twin::EffectInfo* const info = twin::findEffect(effect.id);
    return block == name(info != nullptr ? blockOf(info->part) : Block::kPlant);
  });
}

bool GradedCase::rightBlock() const {
  if (answer == nullptr) return false;
  return acts(answer->block.empty() && !answer->places.empty() ? answer->places.front().block : answer->block);
}

bool GradedCase::firstOpenBlockRight() const {
  return answer != nullptr && acts(answer->first_open_block);
}

bool GradedCase::right() const {
  switch (key.kind) {
    case CaseClass::kSingle:
    case CaseClass::kDouble:
      return namedAll();
    case CaseClass::kEffectFree:
      return hasVerdict("none");
    case CaseClass::kOutside:
      return hasVerdict("unknown") && rightPlace();
  }
  return false;
}

bool GradedCase::fair() const {
  switch (key.kind) {
    case CaseClass::kSingle:
    case CaseClass::kDouble:
      return honest() && namesNothingFalse();
    case CaseClass::kEffectFree:
      return !alarm();
    case CaseClass::kOutside:
      return hasVerdict("unknown");
  }
  return false;
}

std::string GradedCase::truth() const {
  return key.effects.empty() ? "nothing" : idsOf(key.effects);
}

std::string GradedCase::answered() const {
  if (answer == nullptr) return "no answer in time";
  if (hasVerdict("none")) return "nothing";
  if (hasVerdict("named")) return idsOf(answer->effects);
  if (hasVerdict("ambiguous"))
    return "ambiguous: " + (answer->ambiguity.empty() ? idsOf(answer->effects) : listed(answer->ambiguity[0], " or "));
  if (hasVerdict("unknown") && key.kind == CaseClass::kOutside) return "unknown, another place";
  return answer->verdict;
}

}  // namespace darwinop::gap
