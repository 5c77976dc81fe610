#include "gap/identify/shown.hpp"

#include <algorithm>

#include "gap/case/data_check.hpp"

namespace darwinop::gap {

std::vector<const twin::EffectInfo*> effectsNotShown(const Case& given) {
  const std::vector<DataFinding> findings = checkData(given).findings;
  const auto is_absent = [&](twin::LogFeature feature) {
    return std::ranges::any_of(
        findings, [&](const DataFinding& finding) { return finding.feature == feature && !finding.reveals; });
  };
  std::vector<const twin::EffectInfo*> hidden = candidateEffectsOf(given);
  std::erase_if(hidden, [&](const twin::EffectInfo* effect) {
    return effect->revealed_by.empty() || !std::ranges::all_of(effect->revealed_by, is_absent);
  });
  return hidden;
}

}  // namespace darwinop::gap
