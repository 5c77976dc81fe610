// The fault table in docs/virtual-robot.md lists exactly the existing kinds.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "hil-mocks/fault.hpp"
#include "hil-mocks/fault_script.hpp"

namespace darwinop::hil {
namespace {

/// First cells of the table with this header, without backquotes.
std::vector<std::string> firstCells(std::string_view head) {
  std::ifstream page{std::string{DARWINOP_DOCS} + "/virtual-robot.md"};
  std::vector<std::string> cells;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(head)) inside = true;
    if (!line.starts_with('|')) inside = false;
    if (inside && line.starts_with("| `")) cells.push_back(line.substr(3, line.find('`', 3) - 3));
  }
  return cells;
}

TEST(FaultScriptDocs, TheTableListsEveryKindOnceInEnumOrder) {
  const std::vector<std::string> kinds{kFaultKindNames.begin(), kFaultKindNames.end()};
  EXPECT_EQ(firstCells("| Kind | Arguments |"), kinds);
}

TEST(FaultScriptFuzzer, BeginsWithEveryKind) {
  std::ifstream seed{std::string{DARWINOP_DOCS} + "/../tests/fuzz/corpus/fault_script_fuzz/every_kind"};
  const std::string script{std::istreambuf_iterator<char>{seed}, {}};
  FaultKinds kinds;
  for (const InjectedFault& fault : parseFaultScript(script, "every_kind"))
    kinds.set(static_cast<std::size_t>(fault.kind));
  EXPECT_TRUE(kinds.all()) << kinds;
}

}  // namespace
}  // namespace darwinop::hil
