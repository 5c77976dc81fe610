// The nearest known word, units that are converted, and texts put together.
#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "core/text/nearest.hpp"
#include "core/text/shell_word.hpp"
#include "core/text/template.hpp"
#include "core/text/unit_factor.hpp"

namespace darwinop::text {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::array<std::string_view, 3> kKnown{"coulomb", "viscous", "backlash"};

TEST(ShellWord, IsQuotedWhereAShellWouldReadItOtherwise) {
  EXPECT_EQ(shellWord("case/fit_1.csv"), "case/fit_1.csv");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's"), R"('it'\''s')");
  EXPECT_EQ(shellWord("~/walk"), "'~/walk'") << "an argument is not expanded";
  EXPECT_EQ(shellWord(""), "''");
}

TEST(Nearest, IgnoresCaseAndFindsOneOrTwoMistakes) {
  EXPECT_EQ(nearest("Colomb", kKnown), "coulomb");
  EXPECT_EQ(nearest("vicsous", kKnown), "viscous");
}

TEST(Nearest, IsEmptyWhenNoWordIsCloseOrTheTextIsLong) {
  EXPECT_EQ(nearest("friction", kKnown), std::nullopt);
  EXPECT_EQ(nearest(std::string(1000, 'c'), kKnown), std::nullopt);
}

TEST(Nearest, ASuggestionNamesTheWordOrAllWords) {
  EXPECT_THAT(suggestion("colomb", kKnown), AllOf(HasSubstr("coulomb"), Not(HasSubstr("viscous"))));
  EXPECT_THAT(suggestion("friction", kKnown), HasSubstr(listed(kKnown)));
}

TEST(UnitFactor, ConvertsWithinAQuantityOnly) {
  EXPECT_EQ(unitFactor("rad", "rad"), 1);
  EXPECT_DOUBLE_EQ(unitFactor("rpm", "rad/s").value_or(0), 0.10471975511965977);
  EXPECT_DOUBLE_EQ(unitFactor("g", "kg").value_or(0), 1e-3);
  EXPECT_DOUBLE_EQ(unitFactor("g", "m/s2").value_or(0), 9.80665);
  EXPECT_EQ(unitFactor("deg", "rad/s"), std::nullopt);
}

TEST(Joined, HasOneSeparatorBetweenTwoWordsEvenIfTheyAreEmpty) {
  EXPECT_EQ(joined(kKnown), "coulomb, viscous, backlash");
  EXPECT_EQ(joined(std::array{"", "b"}, " + "), " + b");
  EXPECT_EQ(joined(std::array<std::string, 0>{}), "");
}

TEST(Formatted, IsAsPrintfAtAnyLength) {
  EXPECT_EQ(formatted("%4d|%.2f|%s", 7, 0.5, "a"), "   7|0.50|a");
  EXPECT_EQ(formatted("%s", std::string(1000, 'c').c_str()), std::string(1000, 'c'));
}

TEST(FilledTemplate, ReplacesEachPlaceOnceAndLeavesWhatIsPutIn) {
  const std::array<TemplatePart, 2> parts{{{"@A@", "@B@"}, {"@B@", "@A@"}}};
  EXPECT_EQ(filledTemplate("<@A@|@B@>", parts), "<@B@|@A@>");
}

TEST(FilledTemplate, AMissingPlaceIsAnError) {
  const std::array<TemplatePart, 2> parts{{{"@A@", ""}, {"@B@", ""}}};
  EXPECT_THROW((void)filledTemplate("@B@ @A@", parts), std::logic_error);
}

}  // namespace
}  // namespace darwinop::text
