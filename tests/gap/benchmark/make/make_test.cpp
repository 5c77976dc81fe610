// A synthetic case looks like a measured one, does not reveal its effect, and agrees with its key.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "core/text/nearest.hpp"
#include "gap/benchmark/make/make_case.hpp"
#include "gap/benchmark/make/simulate_log.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/write_case.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CaseRequest secret(std::uint64_t seed, std::vector<HiddenEffect> effects, Baseline baseline = Baseline::kFriction) {
  CaseRequest request;
  request.name = "c007";
  request.seed = seed;
  request.baseline = baseline;
  request.effects = std::move(effects);
  return request;
}

double rmsOff(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

std::string allText(const Case& c) {
  std::string text = caseAsJson(c, false);
  for (const Trajectory& log : c.logs) text += logAsCsv(log);
  return text;
}

std::string hideError(const CaseRequest& request) {
  try {
    (void)hidden(request);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SyntheticCase, IsReadBackWithoutAWarning) {
  const TemporaryFolder folder;
  for (const Baseline baseline : {Baseline::kFriction, Baseline::kSpeed}) {
    CaseRequest request = secret(3, {{.id = "viscous", .values = {{"damping", 0.02}}}}, baseline);
    request.name = std::string{"c-"} + std::string{nameOf(baseline)};
    hide(request, folder / "suite");
    const Case c = readCase(folder / "suite/cases/" + request.name);
    EXPECT_THAT(c.warnings, ElementsAre());
    EXPECT_THAT(checkData(c).warnings, ElementsAre());
    EXPECT_EQ(c.logs.size(), 10u);
    EXPECT_EQ(c.logs[3].repeat_of, 2u);
    EXPECT_TRUE(c.datasheet.has_value());
  }
  EXPECT_THAT(readKeys(folder / "suite/key.json"),
              ElementsAre(testing::Key("c-CV"), testing::Key("c-W")));  // the second joins the first
}

// Exact: other bits would change every suite.
TEST(SyntheticCase, KeepsTheDataSheetAsCaseFilesWriteIt) {
  const twin::ServoParameters servo = drawnPlan("c", Baseline::kFriction, 1).given.datasheet->servo;
  EXPECT_EQ(servo.kt_nm_a, 1.786);
  EXPECT_EQ(servo.back_emf_vs_rad, 1.786);
  EXPECT_EQ(servo.resistance_ohm, 8.57);
  EXPECT_EQ(servo.speed_max_rad_s, 5.76);
  EXPECT_EQ(servo.speed_gain_per_kp_1_s, 0.3125);
}

TEST(SyntheticCase, IsTheSameForASeedAndAnotherForTheNext) {
  const auto effects = std::vector<HiddenEffect>{{.id = "coulomb", .values = {{"friction", 0.03}}}};
  const std::string first = allText(hidden(secret(5, effects)).given);
  EXPECT_EQ(allText(hidden(secret(5, effects)).given), first);
  EXPECT_NE(allText(hidden(secret(6, effects)).given), first);
}

// docs/gap/tutorial.md has the command. Other noise would differ by a tick or two.
TEST(SyntheticCase, TheShippedExampleCanBeMadeAgain) {
  CaseRequest request = secret(13, {{.id = "coulomb", .severity = 2}}, Baseline::kFrictionless);
  request.name = "example";
  const Case made = hidden(request).given, shipped = readCase(DARWINOP_GAP_EXAMPLE);
  ASSERT_EQ(made.logs.size(), shipped.logs.size());
  for (std::size_t i = 0; i < made.logs.size(); ++i) {
    ASSERT_EQ(made.logs[i].rows(), shipped.logs[i].rows());
    EXPECT_LT(rmsOff(made.logs[i].goal_rad, shipped.logs[i].goal_rad), 1e-6) << made.logs[i].file;
    // It was drawn while the range of friction ended at 0.3 N m, which gave 0.00883 in place of 0.00915 N m.
    EXPECT_LT(rmsOff(made.logs[i].position_rad, shipped.logs[i].position_rad), 0.002) << made.logs[i].file;
  }
}

// Two-sided: noise that is missing would be as wrong as a gap.
TEST(SyntheticCase, WithoutEffectClosesToTheFloor) {
  for (const Baseline baseline : {Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed, Baseline::kFine}) {
    const Case c = hidden(secret(2, {}, baseline)).given;
    for (std::size_t i = 0; i < c.logs.size(); ++i) {
      if (c.logs[i].kind == "release") continue;  // a limp arm multiplies what is small
      Trace trace;
      rollOut(c, i, baselineOf(c), {}, trace);
      const double off_rad = rmsOff(trace[kPositionSignal], c.logs[i].position_rad);
      EXPECT_GT(off_rad, 0.0005) << nameOf(baseline) << " " << c.logs[i].file;
      EXPECT_LT(off_rad, 0.0015) << nameOf(baseline) << " " << c.logs[i].file;
    }
  }
}

// The two integrators have nothing in common but the equations: without noise and rounding they agree far below a step
// of the encoder (1.5 mrad). The law speed_p changes its speed at once; the integrator of the fits needs fine steps for
// that.
TEST(SyntheticCase, IsIntegratedInAnotherWayWithTheSameResult) {
  for (const Baseline baseline : {Baseline::kFriction, Baseline::kSpeed}) {
    CasePlan plan = drawnPlan("c001", baseline, 4);
    plan.given.quantised = false;
    const Truth truth{.bench = baselineOf(plan.given), .outside = {}};
    for (const std::size_t i : {0u, 1u, 4u, 5u}) {  // slow, steps, bang, release
      Trajectory& log = plan.given.logs[i];
      measure(plan, truth, nullptr, log);
      Trace trace;
      rollOut(plan.given, i, truth.bench, {.steps_per_period = 10}, trace);
      EXPECT_LT(rmsOff(trace[kPositionSignal], log.position_rad), 0.0001) << nameOf(baseline) << " " << log.file;
      EXPECT_NE(trace[kPositionSignal], log.position_rad);
    }
  }
}

double furthestFolded(const CasePlan& plan, const Hypothesis& bench, double (*of)(const Trace&, const Trace&)) {
  double worst = 0;
  for (const std::size_t i : {0u, 1u, 4u, 5u, 8u}) {  // slow, steps, bang, release, moves
    Trace folded, every;
    rollOut(plan.given, i, bench, {}, folded);
    rollOut(plan.given, i, bench, {.steps_per_period = 1}, every);
    worst = std::max(worst, of(folded, every));
  }
  return worst;
}

// A firmware of 0.1 ms is folded into periods of 0.5 ms: a fifth of the work, and a small part of an encoder's step.
TEST(SyntheticCase, OfAFineFirmwareIsSimulatedInCoarserPeriods) {
  const CasePlan plan = drawnPlan("c001", Baseline::kFine, 4);
  ASSERT_FALSE(plan.given.quantised);
  const auto position = [](const Trace& a, const Trace& b) { return rmsOff(a[kPositionSignal], b[kPositionSignal]); };
  const auto load = [](const Trace& a, const Trace& b) { return rmsOff(a[kLoadSignal], b[kLoadSignal]); };
  EXPECT_LT(furthestFolded(plan, baselineOf(plan.given), position), 0.00002);
  EXPECT_LT(furthestFolded(plan, baselineOf(plan.given), load), 0.0002);
  // Profiles are on their way, controllers remember, springs swing.
  for (const char* id :
       {"speed_limit", "accel_limit", "derivative", "integral", "transport_delay", "joint_flex", "backlash"}) {
    Hypothesis bench = baselineOf(plan.given);
    const twin::EffectInfo& info = *twin::findEffect(id);
    twin::EffectSetting& effect = bench.with(info);
    for (std::size_t i = 0; i < effect.values.size(); ++i) effect.values[i] = info.parameters[i].typical;
    EXPECT_LT(furthestFolded(plan, bench, position), 0.0002) << id;
  }
}

TEST(SyntheticCase, DoesNotRevealItsEffect) {
  const TemporaryFolder folder;
  hide(
      secret(8, {{.id = "cogging", .values = {{"amplitude", 0.06}, {"count", 24}}}, {.id = "deadband", .severity = 2}}),
      folder / "suite");
  EXPECT_THAT(textOf(folder / "suite/key.json"), HasSubstr("cogging"));
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder / "suite/cases"}) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::string text = textOf(entry.path()) + entry.path().filename().string();
    for (const char* word :
         {"cogging", "deadband", "amplitude", "width", "effect", "severity", "hidden", "seed", "key"})
      EXPECT_EQ(text.find(word), std::string::npos) << entry.path() << ": " << word;
  }
  EXPECT_EQ(files, 11);
}

TEST(SyntheticCase, HasAKeyThatIncludesTheBaselinesFriction) {
  const Hidden made = hidden(secret(5, {{.id = "coulomb", .values = {{"friction", 0.03}}}}));
  const double believed = baselineOf(made.given).find("coulomb")->values[0];
  ASSERT_EQ(made.key.effects.size(), 1u);
  EXPECT_NEAR(made.key.effects[0].values.at("friction"), believed + 0.03, 1e-12);
  EXPECT_EQ(made.key.kind, CaseClass::kSingle);
  EXPECT_GT(made.key.gap_fit_rad, 5 * made.key.noise_fit_rad);
}

TEST(SyntheticCase, MayHaveABenchThatDiffersSlightlyFromItsModel) {
  CaseRequest request = secret(9, {});
  request.wrong_numbers = true;
  const Hidden made = hidden(request);
  EXPECT_FALSE(made.key.exact);
  EXPECT_EQ(made.key.kind, CaseClass::kEffectFree);
  ASSERT_EQ(made.key.number_factors.size(), made.given.priors.size());
  for (const Prior& prior : made.given.priors)
    EXPECT_LE(std::abs(made.key.number_factors.at(prior.number) - 1), prior.relative_sigma * (1 + 1e-9))
        << prior.number;
  EXPECT_GT(made.key.gap_fit_rad, made.key.noise_fit_rad);
  request.wrong_numbers = false;
  EXPECT_THAT(hidden(request).key.number_factors, testing::IsEmpty());
}

TEST(SyntheticCase, CanBeLikeAnotherCase) {
  const Case other = hidden(secret(5, {})).given;
  CaseRequest request = secret(6, {{.id = "transport_delay", .values = {{"delay", 0.02}}}});
  request.like = other;
  const Hidden made = hidden(request);
  EXPECT_EQ(made.given.name, "c007");
  EXPECT_EQ(made.key.baseline, "CV");
  for (std::size_t i = 0; i < other.logs.size(); ++i) {
    EXPECT_EQ(made.given.logs[i].goal_rad, other.logs[i].goal_rad);
    EXPECT_NE(made.given.logs[i].position_rad, other.logs[i].position_rad);
  }
}

TEST(SyntheticCase, RefusesWhatCannotBeHidden) {
  EXPECT_THAT(hideError(secret(1, {{.id = "colomb"}})), HasSubstr(text::suggestion("colomb", twin::effectIds())));
  EXPECT_THAT(hideError(secret(1, {{.id = "coulomb", .values = {{"fricton", 0.1}}}})), HasSubstr("friction"));
  EXPECT_THAT(hideError(secret(1, {{.id = "backlash", .values = {{"play", 0.5}}}})), HasSubstr("0 to 0.06 rad"));
  CaseRequest request = secret(1, {});
  request.name = "../key";
  EXPECT_THAT(hideError(request), HasSubstr("`../key`"));
}

}  // namespace
}  // namespace darwinop::gap
