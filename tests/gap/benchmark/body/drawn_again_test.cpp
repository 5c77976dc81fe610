// Redraw of effects that are not visible.
#include <gmock/gmock.h>

#include "gap/benchmark/body/body_suite.hpp"

namespace darwinop::gap {
namespace {

TEST(HiddenBody, AnEffectThatDoesNotShowIsDrawnAgain) {
  BodyRequest request = bodyRequests(2026, BodyPart::kPairs).at(9), once = request;
  once.tries = 1;
  const auto placesOf = [](const BodyRequest& of) {
    std::vector<std::vector<std::string>> places;
    for (const BodyKeyEffect& effect : hiddenBody(of).key.effects) places.push_back(effect.at);
    return places;
  };
  EXPECT_NE(placesOf(request), placesOf(once));
}

}  // namespace
}  // namespace darwinop::gap
