// An effect in one file goes through simulation, synthetic cases, localization, identification, model file and export.
#include <gmock/gmock.h>

#include "gap/benchmark/make/make_case.hpp"
#include "gap/benchmark/make/own_suite.hpp"
#include "gap/case/data_check.hpp"
#include "gap/export/holds.hpp"
#include "gap/export/targets.hpp"
#include "gap/report/read_results.hpp"
#include "gap/report/results.hpp"
#include "gap/small_case.hpp"
#include "gap/workflow.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kId = "return_spring";
constexpr double kStiffness = 0.25;  // N m/rad

/// Hidden in the small bench.
Hidden hiddenSpring() {
  CaseRequest request;
  request.like = smallBench();
  request.effects = {{.id = kId, .values = {{"stiffness", kStiffness}}}};
  return hidden(request);
}

TEST(AddedEffect, IsSimulated) {
  const Case bench = smallBench();
  Trace without, with;
  rollOut(bench, 1, baselineOf(bench), {}, without);
  rollOut(bench, 1, withEffect(bench, kId, "stiffness", kStiffness), {}, with);
  EXPECT_GT(std::abs(with[kPositionSignal].back() - without[kPositionSignal].back()), 0.01);
}

TEST(AddedEffect, IsHiddenInTheProjectsOwnSuite) {
  std::size_t cases = 0;
  for (const CaseRequest& request : ownRequests(1, Part::kSingles)) cases += request.effects.front().id == kId;
  EXPECT_EQ(cases, 9u) << "three baselines, three severities";
}

TEST(AddedEffect, IsListedByTheDataCheckWhereDataCannotShowIt) {
  Case bench = hiddenSpring().given;
  for (Trajectory& log : bench.logs) log.payload_kg = 0.3;
  const DataCheck check = checkData(bench);
  const auto payloads = std::ranges::find(check.findings, "payloads", &DataFinding::id);
  ASSERT_NE(payloads, check.findings.end());
  EXPECT_THAT(payloads->effects, Contains(kId));
}

TEST(AddedEffect, IsLocalizedIdentifiedAndWrittenIntoAModel) {
  const Hidden made = hiddenSpring();
  ASSERT_THAT(made.key.effects, testing::SizeIs(1));
  const Outcome outcome = investigate(made.given);
  ASSERT_TRUE(outcome.localization.blocks.first);
  EXPECT_EQ(*outcome.localization.blocks.first, Block::kPlant);

  const Identification& found = outcome.identification;
  EXPECT_EQ(found.verdict, Verdict::kNamed);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].effect->id, kId);
  EXPECT_NEAR(found.effects[0].estimates[0].value, kStiffness, 0.1 * kStiffness);

  const std::string results = asJson(made.given, outcome).dump();
  const std::string repaired =
      withAdditions("[model]\nname = small\n", additionsIn(results, "results.json", made.given));
  const twin::Model model = twin::parseModel(repaired, "repaired.ini");
  const auto written = std::ranges::find_if(model.effects, [](const auto& one) { return one.info->id == kId; });
  ASSERT_NE(written, model.effects.end()) << repaired;
  EXPECT_NEAR(written->values[0], kStiffness, 0.1 * kStiffness);
}

TEST(AddedEffect, IsInExportsAndInTheirTable) {
  ExportSettings settings;
  settings.joint = "ArmUpperR";
  const Case bench = smallBench();
  for (const TargetInfo& target : kTargetTable)
    EXPECT_THAT(exportTo(target.target, withEffect(bench, kId, "stiffness", kStiffness), settings).lost,
                Contains(HasSubstr(kId)));
  EXPECT_THAT(holdingsAsMarkdown(), HasSubstr("`return_spring`"));
}

}  // namespace
}  // namespace darwinop::gap
