// Binary to text to binary is lossless for any file.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "managers/motion/pages.hpp"
#include "managers/motion_text/any_pages.hpp"
#include "managers/motion_text/page_text.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {
namespace {

std::vector<std::uint8_t> throughText(const std::vector<std::uint8_t>& bytes) {
  return encodePages(parsePages(writePages(decodePages(bytes)), "pages.txt"));
}

RC_GTEST_PROP(MotionText, AnyFileSurvivesTheWayThroughText, (std::uint32_t seed)) {
  std::mt19937 rng{seed};
  const std::vector<std::uint8_t> bytes = encodePages(anyFile(rng));
  RC_ASSERT(throughText(bytes) == bytes);
}

TEST(MotionText, TheVendorsFileIsUnchanged) {
  if (!std::filesystem::exists(vendorsFile())) GTEST_SKIP() << "the vendor's motion file is not available";
  const PageFile pages = vendorsPages();
  EXPECT_EQ(throughText(encodePages(pages)), encodePages(pages));
  EXPECT_EQ(parsePages(writePages(pages), "pages.txt"), pages);
}

TEST(MotionText, EveryWordHasAUniqueText) {
  for (int word = 0; word <= 0xFFFF; ++word)
    ASSERT_EQ(angleFromText(angleText(static_cast<std::uint16_t>(word))), word);
  for (int byte = 0; byte <= 0xFF; ++byte) {
    const auto value = static_cast<std::uint8_t>(byte);
    ASSERT_EQ(secondsFromText(secondsText(value)), value);
    ASSERT_EQ(gainFromText(gainText(value)), value);
    ASSERT_EQ(byteFromText(byteText(value)), value);
  }
}

TEST(MotionText, APageHasThisFormat) {
  PageFile pages = emptyFile();
  pages[0] = defaultPage(0);
  Page& page = pages[12];
  page = pageOf({stepTo(2048, 125), stepTo(1024, 25, 18)}, 32);
  for (Step& step : page.step)
    for (const std::size_t id : {0U, 21U, 22U, 23U, 24U, 25U, 26U, 27U, 28U, 29U, 30U})
      step.position.at(id) = emptyPage().step[0].position.at(id);
  page.name = {'r', 'k'};
  page.slopes[3] = 0x77;
  page.next = 13;
  page.step[1].position[20] = kUnusedWord;
  const std::string text = writePages(pages);
  const std::string head =
      "darwinop motion 1\n\n[page 12]\n"
      "name           = \"rk\"\n"
      "next           = 13\n"
      "gain ArmUpperR = 8\n"
      "time           =    1.000    0.200\n"
      "pause          =    0.000    0.144\n"
      "ShoulderR      =     0.00   -90.00\n";
  EXPECT_EQ(text.substr(0, head.size()), head);
  const std::string tail = "Head           =     0.00     keep\n";
  EXPECT_EQ(text.substr(text.size() - tail.size()), tail) << "ids without a joint are omitted";
}

TEST(MotionText, AcceptsOtherSpellings) {
  const PageFile pages = parsePages(
      "\xEF\xBB\xBF"
      "darwinop motion 1  # a remark\r\n"
      "  [page 7]\r\n"
      "name=\"a # b\"   # a remark\r\n"
      "\r\n"
      "\tHead =10 +10.04 1e1\n"
      "time= 1 0.5 0.501\n"
      "steps=2",
      "pages.txt");
  EXPECT_EQ(pages[7].nameText(), "a # b");
  EXPECT_EQ(pages[7].steps, 2);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(pages[7].step.at(i).position[20], 2162) << "10 degrees, nearest tick";
  EXPECT_EQ(pages[7].step[0].time, 125);
  EXPECT_EQ(pages[7].step[1].time, 62) << "0.496 s";
  EXPECT_EQ(pages[7].step[2].time, 63) << "0.504 s";
  EXPECT_EQ(pages[7].step[0].position[1], kUnusedWord) << "joints without a row keep their targets";
}

}  // namespace
}  // namespace darwinop::motion
