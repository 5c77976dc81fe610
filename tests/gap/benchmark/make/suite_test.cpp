// The project's own suite has the promised cases, and their names do not reveal the effects.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "gap/benchmark/make/outside.hpp"
#include "gap/benchmark/make/own_suite.hpp"
#include "support/temporary_folder.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

bool isOutside(const CaseRequest& request) {
  return request.effects.size() == 1 && findOutside(request.effects[0].id) != nullptr;
}

std::size_t countIf(const std::vector<CaseRequest>& all, bool (*is)(const CaseRequest&)) {
  return static_cast<std::size_t>(std::ranges::count_if(all, is));
}

TEST(OwnSuite, HasEnoughOfEverything) {
  const auto all = ownRequests(1, Part::kAll);
  EXPECT_GE(countIf(all, [](const auto& r) { return r.effects.size() == 1 && !isOutside(r); }), 200u);
  EXPECT_EQ(countIf(all, [](const auto& r) { return r.effects.empty(); }), 100u);
  EXPECT_EQ(countIf(all, [](const auto& r) { return r.effects.empty() && r.wrong_numbers; }), 50u);
  EXPECT_EQ(countIf(all, [](const auto& r) { return r.effects.size() == 2; }), 30u);
  EXPECT_EQ(countIf(all, [](const auto& r) { return isOutside(r); }), 20u);

  std::set<std::string> hidden_ids, outside_ids;
  std::map<std::string, std::set<int>> severities;
  std::map<Baseline, int> baselines;
  for (const CaseRequest& request : all) {
    ++baselines[request.baseline];
    for (const HiddenEffect& effect : request.effects) {
      (findOutside(effect.id) != nullptr ? outside_ids : hidden_ids).insert(effect.id);
      if (request.effects.size() == 1) severities[effect.id].insert(effect.severity);
    }
  }
  EXPECT_EQ(hidden_ids.size(), twin::catalogue().size());
  EXPECT_GE(outside_ids.size(), 5u);
  EXPECT_THAT(severities["coulomb"], testing::ElementsAre(1, 2, 3));
  EXPECT_EQ(baselines.size(), 4u);
}

TEST(OwnSuite, HasNamesAndAnOrderThatRevealNothing) {
  const auto all = ownRequests(1, Part::kAll);
  EXPECT_EQ(all[0].name, "c001");
  std::set<std::uint64_t> seeds;
  std::set<std::size_t> sizes;
  for (const CaseRequest& request : all) seeds.insert(request.seed);
  for (std::size_t i = 0; i < 20; ++i) sizes.insert(all[i].effects.size());
  EXPECT_EQ(seeds.size(), all.size());
  EXPECT_GE(sizes.size(), 2u);
}

std::string textOf(const std::vector<CaseRequest>& all) {
  std::string text;
  for (const CaseRequest& request : all) {
    text += request.name + " " + std::to_string(request.seed);
    for (const HiddenEffect& effect : request.effects) text += " " + effect.id + std::to_string(effect.severity);
  }
  return text;
}

TEST(OwnSuite, IsTheSameForASeedAndAnotherForTheNext) {
  for (const Part part : {Part::kQuick, Part::kPairs}) {
    EXPECT_EQ(textOf(ownRequests(4, part)), textOf(ownRequests(4, part)));
    EXPECT_NE(textOf(ownRequests(4, part)), textOf(ownRequests(5, part)));
  }
}

TEST(OwnSuite, HasAQuickPartOfTwelve) {
  const auto quick = ownRequests(kEverydaySeed, Part::kQuick);
  EXPECT_EQ(quick.size(), 12u);
  EXPECT_EQ(countIf(quick, [](const auto& r) { return r.effects.empty(); }), 3u);
  EXPECT_EQ(countIf(quick, [](const auto& r) { return r.effects.size() == 2; }), 1u);
  EXPECT_EQ(countIf(quick, [](const auto& r) { return isOutside(r); }), 1u);
}

TEST(OwnSuite, IsWrittenWithTheKeyBesideTheCases) {
  const TemporaryFolder folder;
  auto few = ownRequests(6, Part::kEffectFree);
  few.resize(2);
  std::size_t done = 0;
  makeCases(folder / "own", few, [&](std::size_t now, std::size_t of) {
    done = std::max(done, now);
    EXPECT_EQ(of, 2u);
  });
  EXPECT_EQ(done, 2u);
  EXPECT_THAT(readKeys(folder / "own/key.json"), testing::ElementsAre(testing::Key("c001"), testing::Key("c002")));
  for (const CaseRequest& request : few) EXPECT_EQ(readCase(folder / "own/cases/" + request.name).name, request.name);
  EXPECT_THROW(makeCases(folder / "own", few), std::runtime_error);  // an old case would be without a key
}

}  // namespace
}  // namespace darwinop::gap
