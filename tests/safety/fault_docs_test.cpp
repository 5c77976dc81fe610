// docs/faults.md and docs/states.md name every row and every state.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/faults.hpp"
#include "safety/states.hpp"

namespace darwinop::safety {
namespace {

std::string page(const std::string& name) {
  const std::ifstream file{std::string{DARWINOP_DOCS} + "/" + name};
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(FaultDocs, EveryFaultHasItsHeadingMeaningAndRemedy) {
  const std::string text = page("faults.md");
  for (const FaultRow& fault : kFaultTable) {
    const std::string heading =
        "\n## " + std::to_string(static_cast<int>(fault.fault)) + " " + std::string{fault.name} + "\n";
    EXPECT_NE(text.find(heading), text.npos) << "docs/faults.md lacks the heading" << heading;
  }
  for (const std::string_view limit : kLimitNames)
    EXPECT_NE(text.find("`" + std::string{limit} + "`"), text.npos) << limit;
}

TEST(FaultDocs, EveryStateAndEventIsOnTheStatesPage) {
  const std::string text = page("states.md");
  for (const std::string_view name : kStateNames)
    EXPECT_NE(text.find("`" + std::string{name} + "`"), text.npos) << name;
  for (const std::string_view name : kEventNames)
    EXPECT_NE(text.find("`" + std::string{name} + "`"), text.npos) << name;
}

}  // namespace
}  // namespace darwinop::safety
