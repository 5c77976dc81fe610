// The fault table in docs/virtual-robot.md lists exactly the existing kinds.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "hil-mocks/fault.hpp"

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

}  // namespace
}  // namespace darwinop::hil
