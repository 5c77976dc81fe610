// docs/proven.md names the faults that the model causes, and what the judges of a campaign tolerate.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "campaign/leniencies.hpp"
#include "core/faults.hpp"
#include "support/text_of.hpp"

namespace darwinop {
namespace {

/// From one text to the next other one, on one line.
std::string part(std::string text, const std::string& from, const std::string& to) {
  std::ranges::replace(text, '\n', ' ');
  const std::size_t begin = text.find(from), end = text.find(to, begin);
  return begin == text.npos ? "" : text.substr(begin, end - begin);
}

std::string provenPage() {
  return textOf(std::string{DARWINOP_DOCS} + "/proven.md");
}

TEST(ProvenDocs, NameAllThatTheJudgesOfACampaignTolerate) {
  const std::string text = part(provenPage(), "Tolerated", "**");
  for (const LeniencyRow& row : kLeniencyTable) EXPECT_NE(text.find(nameOf(row)), text.npos) << nameOf(row);
}

/// True if the model notes this fault as one with a cause.
bool isCaused(const std::string& model, std::string_view fault) {
  return model.find("1 << FA_" + std::string{fault} + ")") != model.npos ||
         model.find("1 << FA_" + std::string{fault} + " ") != model.npos;
}

TEST(ProvenDocs, NameTheFaultsThatTheModelCausesAndNoOther) {
  const std::string folder = std::string{DARWINOP_DOCS} + "/../tests/model/";
  const std::string model = textOf(folder + "robot.pml") + textOf(folder + "events.pml") + textOf(folder + "guard.pml");
  const std::string caused = part(provenPage(), "The model causes", "Only tests and campaign");
  const std::string others = part(provenPage(), "Only tests and campaign", "##");
  ASSERT_NE(caused, "");
  for (const FaultRow& fault : kFaultTable) {
    const std::string name = "`" + std::string{fault.name} + "`";
    EXPECT_EQ(caused.find(name) != caused.npos, isCaused(model, fault.name)) << name;
    EXPECT_TRUE(isCaused(model, fault.name) || others.find(name) != others.npos) << name;
  }
}

}  // namespace
}  // namespace darwinop
