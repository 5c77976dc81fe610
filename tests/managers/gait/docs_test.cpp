// docs/gait.md contains the table of gait parameters.
#include <gmock/gmock.h>

#include <cstdio>
#include <iterator>
#include <string>

#include "managers/gait/parameters.hpp"
#include "support/text_of.hpp"

namespace darwinop::gait {
namespace {

std::string show(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

TEST(GaitDocs, ThePageHasTheTableOfParameters) {
  const std::string text = textOf(DARWINOP_GAIT_PAGE);
  std::string rows;
  for (const ParameterRow& row : kParameters)
    rows += "| `" + std::string{row.name} + "` | " + show(Parameters{}.*row.field) + " | " + show(row.low) + " to " +
            show(row.high) + " | " + std::string{row.unit} + " | " + std::string{row.meaning} + " |\n";
  EXPECT_THAT(text, testing::HasSubstr(rows)) << "replace the table in docs/gait.md by:\n" << rows;
}

}  // namespace
}  // namespace darwinop::gait
