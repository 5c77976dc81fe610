// What people found by hand in 2013, from their own numbers: the verdicts that are right. docs/gap/thesis.md.
#include <gmock/gmock.h>

#include <set>

#include "experiments/logs/read_log.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/write_case.hpp"
#include "gap/identify/identification.hpp"
#include "thesis_cases.hpp"

namespace darwinop::gap {
namespace {

using testing::UnorderedElementsAre;

struct Told {
  Identification naming;
  std::string trail;  // what the search said on its way
};

Told namedIn(const Case& given) {
  Told told;
  IdentifyOptions options;
  options.progress = [&](const std::string& what) { told.trail += what + "\n"; };
  told.naming = identify(Study{given}, options);
  told.trail += std::string{nameOf(told.naming.verdict)} + ", misfit " + std::to_string(told.naming.misfit) + "\n";
  for (const IdentifiedEffect& found : told.naming.effects)
    for (const Estimate& e : found.estimates)
      told.trail += e.name + " = " + std::to_string(e.value) + " " + e.unit + ", " + std::to_string(e.low) + " to " +
                    std::to_string(e.high) + "\n";
  for (const Rival& rival : told.naming.rivals)
    told.trail += "rival " + rival.effects.back() + " worse by " + std::to_string(rival.behind) + "\n";
  for (const PriorConflict& one : told.naming.prior_conflicts)
    told.trail += one.number + " strained by " + std::to_string(one.sigmas) + " sigma\n";
  return told;
}

std::vector<std::string> idsIn(const Identification& naming) {
  std::vector<std::string> ids;
  for (const IdentifiedEffect& found : naming.effects) ids.emplace_back(found.effect->id);
  return ids;
}

/// The value of the parameter of what was found; NaN: it was not.
double valueIn(const Identification& naming, const std::string& name) {
  for (const IdentifiedEffect& found : naming.effects)
    for (const Estimate& estimate : found.estimates)
      if (estimate.name == name) return estimate.value;
  return std::numeric_limits<double>::quiet_NaN();
}

// The first guess of 2013 was the speed.
TEST(Thesis, T1HeadSweepsMissALimitOfTheAccelerationAndNotOneOfTheSpeed) {
  const Told told = namedIn(thesis::speedTest());
  EXPECT_EQ(told.naming.verdict, Verdict::kNamed) << told.trail;
  EXPECT_THAT(idsIn(told.naming), UnorderedElementsAre("accel_limit")) << told.trail;
  EXPECT_NEAR(valueIn(told.naming, "accel_limit.accel"), 55, 5.5) << told.trail;
}

TEST(Thesis, T2AnArmLetGoMissesDryFrictionBesideTheViscous) {
  const Told told = namedIn(thesis::freeSwing());
  EXPECT_EQ(told.naming.verdict, Verdict::kNamed) << told.trail;
  EXPECT_THAT(idsIn(told.naming), UnorderedElementsAre("coulomb", "viscous")) << told.trail;
  EXPECT_NEAR(valueIn(told.naming, "coulomb.friction"), 0.025, 0.0025) << told.trail;
  EXPECT_NEAR(valueIn(told.naming, "viscous.damping"), 0.002, 0.0004) << told.trail;
}

TEST(Thesis, T3AnArmThatNeverArrivesHasPOnTorque) {
  const Told told = namedIn(thesis::lowGainStep());
  EXPECT_EQ(told.naming.verdict, Verdict::kNamed) << told.trail;
  EXPECT_THAT(idsIn(told.naming), UnorderedElementsAre("p_on_torque")) << told.trail;
}

/// What reading the case from files says; empty: nothing.
std::string refusalOf(const Case& given) {
  const CaseFiles files{.log =
                            [&](const std::string& name) {
                              for (const Trajectory& log : given.logs)
                                if (log.file == name) return logs::parseLog(logAsCsv(log), name);
                              throw std::runtime_error(name);
                            },
                        .model = {}};
  try {
    parseCase(caseAsJson(given, false), "case.json", files);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "";
}

// Not an effect of the servo but of who wrote the log: refused, with the reason, before anything is named.
TEST(Thesis, T4AMirroredLoadIsToldByItsSign) {
  Case told = thesis::mirroredLoad();
  EXPECT_THAT(refusalOf(told), testing::HasSubstr("its sign is mirrored"));
  for (Trajectory& log : told.logs)
    for (double& load : log.load) load = -load;
  EXPECT_EQ(refusalOf(told), "");
}

// "Small resistances or masses": from an arm that only rises nobody can say more.
TEST(Thesis, T7AnArmThatOnlyRisesLeavesItOpenWhetherFrictionOrMassIsMissing) {
  const Told told = namedIn(thesis::risingArm());
  EXPECT_EQ(told.naming.verdict, Verdict::kAmbiguous) << told.trail;
  std::set<std::string> all;
  for (const std::string& id : idsIn(told.naming)) all.insert(id);
  // Among the rivals at least: other frictions and the resistance of the motor stand nearer, docs/gap/thesis.md.
  for (const Rival& rival : told.naming.rivals) all.insert(rival.effects.back());
  EXPECT_THAT(all, testing::IsSupersetOf({"coulomb", "com_mass"})) << told.trail;
}

TEST(Thesis, T8KicksThatDifferByTheirMotionFileMissNothing) {
  const Told told = namedIn(thesis::kicks());
  EXPECT_EQ(told.naming.verdict, Verdict::kNone) << told.trail;
}

}  // namespace
}  // namespace darwinop::gap
