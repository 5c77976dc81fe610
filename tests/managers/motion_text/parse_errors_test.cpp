// What is wrong with a text is said with file, line and field.
#include <gtest/gtest.h>

#include <stdexcept>

#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {
namespace {

std::string sentenceAbout(const std::string& text) {
  try {
    (void)parsePages(text, "a.txt");
  } catch (const std::runtime_error& why) {
    return why.what();
  }
  return "it is accepted";
}

/// About a page whose first field is on line 3.
std::string inPage(const std::string& lines) {
  return sentenceAbout("darwinop motion 1\n[page 7]\n" + lines);
}

constexpr const char* kTitle = "a.txt, line 1: the text of a motion file begins with the line 'darwinop motion 1'";

TEST(MotionTextErrors, OfTheTextAsAWhole) {
  EXPECT_EQ(sentenceAbout("darwinop motion 1"), "it is accepted");
  EXPECT_EQ(sentenceAbout(""), kTitle);
  EXPECT_EQ(sentenceAbout("darwinop motion 2\n"), kTitle);
  EXPECT_EQ(sentenceAbout("darwinop motion 1\nname = \"x\"\n"),
            "a.txt, line 2: write [page NUMBER] before the first field");
  for (const char* heading : {"[page]", "[page 256]", "[page -1]", "[page x]", "[page 1", "[side 1]"})
    EXPECT_EQ(sentenceAbout(std::string{"darwinop motion 1\n"} + heading),
              "a.txt, line 2: write [page NUMBER] with a number from 0 to 255")
        << heading;
  EXPECT_EQ(inPage("[page 8]\n[page 7]\n"), "a.txt, line 4: page 7 has been there before");
  EXPECT_EQ(inPage("bow\n"), "a.txt, line 3, page 7: write FIELD = VALUE, or [page NUMBER]");
}

TEST(MotionTextErrors, OfAField) {
  EXPECT_EQ(inPage("knee = 1\n"),
            "a.txt, line 3, page 7: 'knee' is no field of a page; it is a joint's name, or one of name, repeat, next, "
            "exit, speed, acceleration, schedule, steps, time, rate, pause, gain JOINT, others");
  EXPECT_EQ(inPage("gain knee = 8").substr(0, 37), "a.txt, line 3, page 7: 'gain knee' is");
  EXPECT_EQ(inPage("id 5 = 8").substr(0, 30), "a.txt, line 3, page 7: 'id 5' ") << "it has a name";
  EXPECT_EQ(inPage("next = 1\n\nnext = 1\n"), "a.txt, line 5, page 7: next: the page has it twice");
  for (const std::string field : {"repeat", "next", "exit", "speed"})
    EXPECT_EQ(inPage(field + " = 256"),
              "a.txt, line 3, page 7: " + field + ": '256' is not a whole number from 0 to 255");
  EXPECT_EQ(inPage("steps = 8"), "a.txt, line 3, page 7: steps: '8' is not a whole number from 0 to 7");
  EXPECT_EQ(inPage("schedule = soon"), "a.txt, line 3, page 7: schedule: 'soon' is not 'time' or 'speed'");
  EXPECT_EQ(inPage("acceleration = 3"),
            "a.txt, line 3, page 7: acceleration: '3' is not a time: 0 to 2.04 seconds, in steps of 0.008");
  EXPECT_EQ(inPage("name = bow"), "a.txt, line 3, page 7: name: put it into double quotes, as in name = \"bow\"");
  EXPECT_EQ(inPage("name = \"fourteen chars\""),
            "a.txt, line 3, page 7: name: it has 14 letters; there is room for 13");
  EXPECT_EQ(inPage("name = \"a\x01\""),
            "a.txt, line 3, page 7: name: it is made of letters, digits and signs of ASCII, without double quotes");
  EXPECT_EQ(inPage("name_bytes = 41"), "a.txt, line 3, page 7: name_bytes: it has 1 bytes; there are 14");
  EXPECT_EQ(inPage("reserved = 0 00 00 00 00 00 00 00 00 00 00"),
            "a.txt, line 3, page 7: reserved: '0' is not a byte of two digits, 00 to FF");
  EXPECT_EQ(inPage("gain Neck = 33"),
            "a.txt, line 3, page 7: gain Neck: '33' is not a gain: 4, 8, 16, 32, 64 or 128, "
            "or the slopes of the file such as 0x57");
}

TEST(MotionTextErrors, OfARow) {
  const std::string angle =
      " is not an angle: degrees from -180.00 to 179.91, 'keep', or a word of the file such as 0x4000";
  for (const std::string wrong : {"x", "180", "-181", "nan", "0x", "0x12345", "1,5", "Keep"})
    EXPECT_EQ(inPage("Neck = 0 " + wrong), "a.txt, line 3, page 7: Neck, step 2: '" + wrong + "'" + angle);
  EXPECT_EQ(inPage("Neck = \x1b[2J"), "a.txt, line 3, page 7: Neck, step 1: '?[2J'" + angle) << "fit for a terminal";
  EXPECT_EQ(inPage("time = -1"),
            "a.txt, line 3, page 7: time, step 1: '-1' is not a time: 0 to 2.04 seconds, in "
            "steps of 0.008");
  EXPECT_EQ(inPage("rate = 1 0.5"), "a.txt, line 3, page 7: rate, step 2: '0.5' is not a whole number from 0 to 255");
  EXPECT_EQ(inPage("pause ="), "a.txt, line 3, page 7: pause: it has 0 values; a page has 1 to 7 steps");
  EXPECT_EQ(inPage("pause = 0 0 0 0 0 0 0 0"),
            "a.txt, line 3, page 7: pause: it has 8 values; a page has 1 to 7 steps");
  EXPECT_EQ(inPage("time = 1 1\nNeck = 0"),
            "a.txt, line 4, page 7: Neck: it has 1 values, and time has 2; every row "
            "has one for each step");
}

TEST(MotionTextErrors, OfAPageAreToldWithTheLineOfItsHeading) {
  EXPECT_EQ(inPage("Neck = 0\n[page 8]\n"),
            "a.txt, line 2, page 7: time: the row is missing; it says how long each step takes");
  EXPECT_EQ(inPage("rate = 1"), "a.txt, line 2, page 7: rate: a page by time has a row 'time' instead");
  EXPECT_EQ(inPage("schedule = speed\ntime = 1"),
            "a.txt, line 2, page 7: time: a page by speed has a row 'rate' instead");
  EXPECT_EQ(inPage("steps = 2\ntime = 1"), "a.txt, line 2, page 7: steps: it is 2, and the rows have 1 values");
  EXPECT_EQ(inPage("schedule = 3\nrate = 1"), "a.txt, line 2, page 7: schedule: it is 3; write 'time' or 'speed'");
  EXPECT_EQ(inPage("speed = 0\ntime = 1"), "a.txt, line 2, page 7: speed: it is 0; it is 1 to 255, 32 is usual");
  EXPECT_EQ(inPage("name = \"a\"\nname_bytes = 41 00 00 00 00 00 00 00 00 00 00 00 00 00"),
            "a.txt, line 2, page 7: name_bytes: the page has a name already");
  EXPECT_EQ(inPage("time = 1\nothers = keep\nid 21 = keep"),
            "a.txt, line 2, page 7: id 21: the page has 'others' already");
}

}  // namespace
}  // namespace darwinop::motion
