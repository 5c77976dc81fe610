// Errors of the text format name file, line, field and what is allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTitle = std::string{kTextTitle} + "\n";

std::string errorOf(const std::string& text) {
  try {
    (void)parsePages(text, "a.txt");
  } catch (const std::runtime_error& why) {
    return why.what();
  }
  return "";
}

/// Error of a page whose first field is in line 3.
std::string inPage(const std::string& lines) {
  return errorOf(kTitle + "[page 7]\n" + lines);
}

/// `field` in a line of a page, or of its heading, line 2.
template <class... Fact>
auto names(int line, const std::string& field, Fact... facts) {
  return AllOf(StartsWith("a.txt, line " + std::to_string(line) + ", page 7: " + field), HasSubstr(facts)...);
}

TEST(MotionTextErrors, OfTheTextAsAWhole) {
  EXPECT_EQ(errorOf(std::string{kTextTitle}), "");
  for (const char* text : {"", "darwinop motion 2\n"})
    EXPECT_THAT(errorOf(text), AllOf(StartsWith("a.txt, line 1: "), HasSubstr("'" + std::string{kTextTitle} + "'")));
  EXPECT_THAT(errorOf(kTitle + "name = \"x\"\n"), AllOf(StartsWith("a.txt, line 2: "), HasSubstr("[page NUMBER]")));
  for (const char* heading : {"[page]", "[page 256]", "[page -1]", "[page x]", "[page 1", "[side 1]"})
    EXPECT_THAT(errorOf(kTitle + heading),
                AllOf(StartsWith("a.txt, line 2: "), HasSubstr("[page NUMBER]"), HasSubstr("0 to 255")))
        << heading;
  EXPECT_THAT(inPage("[page 8]\n[page 7]\n"), StartsWith("a.txt, line 4: page 7 "));
  EXPECT_THAT(inPage("bow\n"), names(3, "", "FIELD = VALUE", "[page NUMBER]"));
}

TEST(MotionTextErrors, OfAField) {
  EXPECT_THAT(inPage("knee = 1\n"), names(3, "'knee' ", "name", "repeat", "next", "exit", "speed", "acceleration",
                                          "schedule", "steps", "time", "rate", "pause", "gain JOINT", "others"));
  EXPECT_THAT(inPage("gain knee = 8"), names(3, "'gain knee' "));
  EXPECT_THAT(inPage("id 5 = 8"), names(3, "'id 5' ")) << "it is a joint";
  EXPECT_THAT(inPage("next = 1\n\nnext = 1\n"), names(5, "next: "));
  for (const std::string field : {"repeat", "next", "exit", "speed"})
    EXPECT_THAT(inPage(field + " = 256"), names(3, field + ": '256' ", "0 to 255"));
  EXPECT_THAT(inPage("steps = 8"), names(3, "steps: '8' ", "0 to 7"));
  EXPECT_THAT(inPage("schedule = soon"), names(3, "schedule: 'soon' ", "'time'", "'speed'"));
  EXPECT_THAT(inPage("acceleration = 3"), names(3, "acceleration: '3' ", "0 to 2.04", "0.008"));
  EXPECT_THAT(inPage("name = bow"), names(3, "name: ", "name = \"bow\""));
  EXPECT_THAT(inPage("name = \"fourteen chars\""), names(3, "name: ", "14", "13"));
  EXPECT_THAT(inPage("name = \"a\x01\""), names(3, "name: ", "ASCII"));
  EXPECT_THAT(inPage("name_bytes = 41"), names(3, "name_bytes: ", " 1 ", "14"));
  EXPECT_THAT(inPage("reserved = 0 00 00 00 00 00 00 00 00 00 00"), names(3, "reserved: '0' ", "00 to FF"));
  EXPECT_THAT(inPage("gain Neck = 33"), names(3, "gain Neck: '33' ", "4, 8, 16, 32, 64 or 128", "0x57"));
}

TEST(MotionTextErrors, OfARow) {
  for (const std::string wrong : {"x", "180", "-181", "nan", "0x", "0x12345", "1,5", "Keep"})
    EXPECT_THAT(inPage("Neck = 0 " + wrong),
                names(3, "Neck, step 2: '" + wrong + "' ", "-180.00 to 179.91", "'keep'", "0x4000"));
  EXPECT_THAT(inPage("Neck = \x1b[2J"), names(3, "Neck, step 1: '?[2J' ")) << "no control characters";
  EXPECT_THAT(inPage("time = -1"), names(3, "time, step 1: '-1' ", "0 to 2.04", "0.008"));
  EXPECT_THAT(inPage("rate = 1 0.5"), names(3, "rate, step 2: '0.5' ", "0 to 255"));
  EXPECT_THAT(inPage("pause ="), names(3, "pause: ", " 0 ", "1 to 7"));
  EXPECT_THAT(inPage("pause = 0 0 0 0 0 0 0 0"), names(3, "pause: ", " 8 ", "1 to 7"));
  EXPECT_THAT(inPage("time = 1 1\nNeck = 0"), names(4, "Neck: ", " 1 ", "time", " 2"));
}

TEST(MotionTextErrors, OfAPageHaveTheLineOfItsHeading) {
  EXPECT_THAT(inPage("Neck = 0\n[page 8]\n"), names(2, "time: "));
  EXPECT_THAT(inPage("rate = 1"), names(2, "rate: ", "'time'"));
  EXPECT_THAT(inPage("schedule = speed\ntime = 1"), names(2, "time: ", "'rate'"));
  EXPECT_THAT(inPage("steps = 2\ntime = 1"), names(2, "steps: ", " 2", " 1 "));
  EXPECT_THAT(inPage("schedule = 3\nrate = 1"), names(2, "schedule: ", " 3", "'time'", "'speed'"));
  EXPECT_THAT(inPage("speed = 0\ntime = 1"), names(2, "speed: ", " 0", "1 to 255"));
  EXPECT_THAT(inPage("name = \"a\"\nname_bytes = 41 00 00 00 00 00 00 00 00 00 00 00 00 00"), names(2, "name_bytes: "));
  EXPECT_THAT(inPage("time = 1\nothers = keep\nid 21 = keep"), names(2, "id 21: ", "'others'"));
}

}  // namespace
}  // namespace darwinop::motion
