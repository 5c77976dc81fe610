// What the judges of a campaign tolerate is counted and reported.
#include "campaign/leniencies.hpp"

#include <gtest/gtest.h>

namespace darwinop {
namespace {

TEST(Leniencies, AreReportedWithTheirCounts) {
  Tolerated tolerated;
  tolerated.note(Leniency::kLateGoal);
  Tolerated more;
  more.note(Leniency::kLateGoal, 41);
  tolerated += more;
  EXPECT_EQ(tolerated.of(Leniency::kLateGoal), 42);
  const std::string text = report(tolerated);
  for (const LeniencyRow& row : kLeniencyTable) EXPECT_NE(text.find(nameOf(row)), text.npos) << nameOf(row);
  EXPECT_NE(text.find("42  " + nameOf(kLeniencyTable[static_cast<std::size_t>(Leniency::kLateGoal)])), text.npos);
}

}  // namespace
}  // namespace darwinop
