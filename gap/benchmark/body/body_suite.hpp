// Own suite of the whole robot: cases by seed, over all effects and places.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gap/benchmark/body/hidden_body.hpp"

namespace darwinop::gap {

enum class BodyPart : std::uint8_t { kQuick, kSingles, kEffectFree, kPairs, kOutside, kAll };

/// Requests in random order, under neutral names.
std::vector<BodyRequest> bodyRequests(std::uint64_t seed, BodyPart part);
/// One case for each of them.
std::vector<BodyRequest> bodyRequestsFor(std::uint64_t seed, const std::vector<std::string>& effects);

/// Writes FOLDER/cases/* and FOLDER/key.json, which must not be there yet.
void makeBodyCases(const std::string& folder, const std::vector<BodyRequest>& requests,
                   const std::function<void(std::size_t done, std::size_t of)>& progress = {});

}  // namespace darwinop::gap
