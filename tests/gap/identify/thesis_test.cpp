// What people found by hand in 2013, from their own numbers: the verdicts that are right. docs/gap/thesis.md.
#include <gmock/gmock.h>

#include <set>

#include "experiments/logs/read_log.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/write_case.hpp"
#include "gap/identify/identification.hpp"
#include "gap/identify/thesis_cases.hpp"

namespace darwinop::gap {
namespace {

using testing::UnorderedElementsAre;

struct Identified {
  Identification identification;
  std::string trail;  // progress of the search
};

Identified namedIn(const Case& given) {
  Identified result;
  IdentifyOptions options;
  options.progress = [&](const std::string& what) { result.trail += what + "\n"; };
  result.identification = identify(Study{given}, options);
  result.trail += std::string{nameOf(result.identification.verdict)} + ", misfit " +
                  std::to_string(result.identification.misfit) + "\n";
  for (const IdentifiedEffect& found : result.identification.effects)
    for (const Estimate& e : found.estimates)
      result.trail += e.name + " = " + std::to_string(e.value) + " " + e.unit + ", " + std::to_string(e.low) + " to " +
                      std::to_string(e.high) + "\n";
  for (const Rival& rival : result.identification.rivals)
    result.trail += "rival " + rival.effects.back() + " worse by " + std::to_string(rival.behind) + "\n";  // no message
  for (const PriorConflict& one : result.identification.prior_conflicts)
    result.trail += one.number + " in conflict with its prior by " + std::to_string(one.sigmas) + " sigma\n";
  return result;
}

std::vector<std::string> idsIn(const Identification& identification) {
  std::vector<std::string> ids;
  for (const IdentifiedEffect& found : identification.effects) ids.emplace_back(found.effect->id);
  return ids;
}

/// The value of the parameter of what was found; NaN: it was not.
double valueIn(const Identification& identification, const std::string& name) {
  for (const IdentifiedEffect& found : identification.effects)
    for (const Estimate& estimate : found.estimates)
      if (estimate.name == name) return estimate.value;
  return std::numeric_limits<double>::quiet_NaN();
}

// The first guess of 2013 was the speed.
TEST(Thesis, T1HeadSweepsMissALimitOfTheAccelerationAndNotOneOfTheSpeed) {
  const Identified result = namedIn(thesis::speedTest());
  EXPECT_EQ(result.identification.verdict, Verdict::kNamed) << result.trail;
  EXPECT_THAT(idsIn(result.identification), UnorderedElementsAre("accel_limit")) << result.trail;
  EXPECT_NEAR(valueIn(result.identification, "accel_limit.accel"), 55, 5.5) << result.trail;
}

TEST(Thesis, T2AReleasedArmShowsDryAndViscousFriction) {
  const Identified result = namedIn(thesis::freeSwing());
  EXPECT_EQ(result.identification.verdict, Verdict::kNamed) << result.trail;
  EXPECT_THAT(idsIn(result.identification), UnorderedElementsAre("coulomb", "viscous")) << result.trail;
  EXPECT_NEAR(valueIn(result.identification, "coulomb.friction"), 0.025, 0.0025) << result.trail;
  EXPECT_NEAR(valueIn(result.identification, "viscous.damping"), 0.002, 0.0004) << result.trail;
}

TEST(Thesis, T3AnArmThatNeverArrivesHasPOnTorque) {
  const Identified result = namedIn(thesis::lowGainStep());
  EXPECT_EQ(result.identification.verdict, Verdict::kNamed) << result.trail;
  EXPECT_THAT(idsIn(result.identification), UnorderedElementsAre("p_on_torque")) << result.trail;
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
TEST(Thesis, T4AMirroredLoadIsRefused) {
  Case mirrored = thesis::mirroredLoad();
  EXPECT_THAT(refusalOf(mirrored), testing::HasSubstr(messages::kLoadHasOppositeSign));
  for (Trajectory& log : mirrored.logs)
    for (double& load : log.load) load = -load;
  EXPECT_EQ(refusalOf(mirrored), "");
}

// "Small resistances or masses": from an arm that only rises nobody can say more.
TEST(Thesis, T7AnArmThatOnlyRisesLeavesItOpenWhetherFrictionOrMassIsMissing) {
  const Identified result = namedIn(thesis::risingArm());
  EXPECT_EQ(result.identification.verdict, Verdict::kAmbiguous) << result.trail;
  std::set<std::string> all;
  for (const std::string& id : idsIn(result.identification)) all.insert(id);
  // Among the rivals at least: other frictions and the resistance of the motor stand nearer, docs/gap/thesis.md.
  for (const Rival& rival : result.identification.rivals) all.insert(rival.effects.back());
  EXPECT_THAT(all, testing::IsSupersetOf({"coulomb", "com_mass"})) << result.trail;
}

TEST(Thesis, T8KicksThatDifferByTheirMotionFileMissNothing) {
  const Identified result = namedIn(thesis::kicks());
  EXPECT_EQ(result.identification.verdict, Verdict::kNone) << result.trail;
}

}  // namespace
}  // namespace darwinop::gap
