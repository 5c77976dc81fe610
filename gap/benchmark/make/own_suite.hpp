// The project's own suite: cases by seed, over all effects, severities and baselines. It shares the servo model with
// the identification, so it shows regressions only; accuracy on other benches needs suites of other simulators.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gap/benchmark/make/make_case.hpp"

namespace darwinop::gap {

enum class Part : std::uint8_t {
  kQuick,       // 12 cases for every day
  kSingles,     // one effect each: 200 and more
  kEffectFree,  // 100, half of them with numbers that are slightly wrong
  kPairs,       // 30 with two effects
  kOutside,     // 20 with something that no catalogue has
  kAll,
};

/// Requests in random order, under neutral names.
std::vector<CaseRequest> ownRequests(std::uint64_t seed, Part part);

/// Fixed, so that runs of different days compare. A second quick suite with a new, printed seed prevents overfitting.
inline constexpr std::uint64_t kEverydaySeed = 20130;

/// After each case: how many are done, of how many. From any thread, one at a time.
using Progress = std::function<void(std::size_t done, std::size_t of)>;
/// Writes FOLDER/cases/* and FOLDER/key.json, which must not be there yet.
void makeCases(const std::string& folder, const std::vector<CaseRequest>& requests, const Progress& progress = {});

}  // namespace darwinop::gap
