// Where no model explains all logs of a session: what half of them shows, and the others confirm.
#include "gap/identify/split_search.hpp"

#include <gtest/gtest.h>

#include "gap/benchmark/make/make_case.hpp"

namespace darwinop::gap {
namespace {

Case measured(const std::vector<HiddenEffect>& effects, std::uint64_t seed) {
  CaseRequest request;
  request.seed = seed;
  request.effects = effects;
  return hidden(request).given;
}

// The horn slips between two logs. From then on the arm hangs at another angle, which no single value of an effect
// explains.
const HiddenEffect kSlip{.id = "u_slip", .values = {{"slip", 0.08}, {"at", 30}}};

TEST(SplitSearch, IdentifyNamesWhatHoldsBeforeAndAfterAJolt) {
  const Case given = measured({{.id = "coulomb", .severity = 3}, kSlip}, 51);
  const Identification found = identify(Study{given});
  EXPECT_EQ(found.verdict, Verdict::kNamed);
  ASSERT_EQ(found.effects.size(), 1U);
  EXPECT_EQ(found.effects.front().effect->id, "coulomb");
  EXPECT_TRUE(found.remains);
  EXPECT_EQ(found.explained.size(), 3U) << "half of the logs";
}

// In the last half alone, an offset of the encoder leaves nothing but noise.
TEST(SplitSearch, GivesTheJoltItselfNoName) {
  const Case given = measured({kSlip}, 51);
  const Study study{given};
  const std::optional<Identification> found = searchInHalves(study, {});
  EXPECT_FALSE(found) << found->effects.front().effect->id;
}

}  // namespace
}  // namespace darwinop::gap
