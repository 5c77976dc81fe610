#include "gap/identify/rivals.hpp"

#include <algorithm>

namespace darwinop::gap {

void carryOn(std::vector<Rival>& rivals, const std::vector<std::string_view>& tested, std::string_view added) {
  std::erase_if(rivals,
                [&](const Rival& rival) { return std::ranges::find(tested, rival.effects.back()) != tested.end(); });
  if (added.empty()) return;
  for (Rival& rival : rivals) rival.effects.emplace(rival.effects.begin(), added);
}

}  // namespace darwinop::gap
