#include "gap/report/rival_text.hpp"

#include "gap/report/messages.hpp"

namespace darwinop::gap {

std::vector<std::string> addedBy(const Rival& rival, const Identification& identification) {
  std::vector<std::string> more = rival.effects;
  for (const IdentifiedEffect& found : identification.effects) std::erase(more, found.effect->id);
  if (more.size() + identification.effects.size() != rival.effects.size()) more.clear();
  return more;
}

// An addition is a rival if it reduces the mean prediction error and the logs disagree.
const char* predictionOf(const Rival& rival, const Identification& identification) {
  return addedBy(rival, identification).empty() ? messages::kPredictsAsWell : messages::kMayPredictBetter;
}

}  // namespace darwinop::gap
