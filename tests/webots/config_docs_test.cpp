// docs/config.md names every setting of the safety layer with its default, range, unit and reason.
#include <gmock/gmock.h>

#include <cstdio>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "safety/config.hpp"
#include "support/text_of.hpp"

namespace darwinop {
namespace {

std::string show(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string tableRow(std::string_view name, const std::string& normal, const std::string& allowed,
                     std::string_view unit, std::string_view why) {
  return "| `" + std::string{name} + "` | " + normal + " | " + allowed + " | " + std::string{unit} + " | " +
         std::string{why} + " |\n";
}

struct Rows {
  std::string text;

  void operator()(std::string_view name, double value, double low, double high, std::string_view unit,
                  std::string_view why) {
    text += tableRow(name, show(value), show(low) + " to " + show(high), unit, why);
  }
  template <class Choice>
  void operator()(std::string_view name, Choice value, std::span<const std::string_view> choices,
                  std::string_view why) {
    std::string allowed;
    for (const std::string_view choice : choices) allowed += (allowed.empty() ? "" : ", ") + std::string{choice};
    text += tableRow(name, std::string{choices[static_cast<std::size_t>(value)]}, allowed, "", why);
  }
};

TEST(ConfigDocs, ThePageHasTheTableOfTheSafetyLayer) {
  const std::string text = textOf(DARWINOP_CONFIG_PAGE);
  Rows rows;
  safety::Config{}.visit(rows);
  EXPECT_THAT(text, testing::HasSubstr(rows.text)) << "put this table into docs/config.md:\n" << rows.text;
}

}  // namespace
}  // namespace darwinop
