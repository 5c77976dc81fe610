#include "gap/localize/blocks.hpp"

#include "gap/localize/block_effect.hpp"
#include "gap/localize/block_finder.hpp"

namespace darwinop::gap {

std::string_view name(BlockVerdict verdict) {
  switch (verdict) {
    case BlockVerdict::kClosed:
      return "closed";
    case BlockVerdict::kOpen:
      return "open";
    case BlockVerdict::kNotTestable:
      break;
  }
  return "not cut";
}

Blocks findBlocks(const Plant& plant, const Case& given, const Hypothesis& baseline,
                  const std::vector<std::size_t>& logs, const SimulatedRepeats& copies) {
  Blocks found = BlockFinder{plant, given, baseline, logs, copies}.find();
  rankBlocks(given, baseline, logs, found);
  return found;
}

}  // namespace darwinop::gap
