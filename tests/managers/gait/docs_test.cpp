// docs/gait.md names every parameter of the gait with its default, range, unit and meaning.
#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "managers/gait/parameters.hpp"

namespace darwinop::gait {
namespace {

std::string show(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

TEST(GaitDocs, ThePageHasTheTableOfParameters) {
  std::ifstream page{DARWINOP_GAIT_PAGE};
  const std::string text{std::istreambuf_iterator<char>{page}, {}};
  std::string rows;
  for (const ParameterRow& row : kParameters)
    rows += "| `" + std::string{row.name} + "` | " + show(Parameters{}.*row.field) + " | " + show(row.low) + " to " +
            show(row.high) + " | " + std::string{row.unit} + " | " + std::string{row.meaning} + " |\n";
  EXPECT_THAT(text, testing::HasSubstr(rows)) << "put this table into docs/gait.md:\n" << rows;
}

}  // namespace
}  // namespace darwinop::gait
