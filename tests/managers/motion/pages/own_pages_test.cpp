// The own pages: what is in the library is what lies in managers/motion/pages/, each number once.
#include "managers/motion/pages/own_pages.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "managers/motion_text/check_pages.hpp"

namespace darwinop::motion {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kOne = "darwinop motion 1\n[page 7]\nname = \"one\"\ntime = 1\nNeck = 10\n";
constexpr const char* kOther = "darwinop motion 1\n[page 8]\nname = \"other\"\ntime = 1\nNeck = -10\n";

std::string refusalOf(std::initializer_list<OwnText> texts) {
  try {
    (void)mergeTexts({texts.begin(), texts.end()});
  } catch (const std::runtime_error& why) {
    return why.what();
  }
  return "";
}

TEST(OwnPages, AreInTheLibraryAndAllOfThemCanBePlayed) {
  ASSERT_EQ(ownPages().size(), kPages);
  EXPECT_TRUE(ownPages()[1].canPlay());
  EXPECT_TRUE(ownPages()[9].canPlay());
  EXPECT_EQ(decodePages(encodePages(ownPages())), ownPages()) << "they can be written as a binary file";
}

TEST(OwnPages, NothingIsFoundWithThem) {
  EXPECT_THAT(checkPages(ownPages()), IsEmpty());
}

TEST(OwnPages, TextsGoTogether) {
  const OwnText texts[] = {{"one.txt", kOne}, {"other.txt", kOther}};
  const PageFile pages = mergeTexts(texts);
  EXPECT_EQ(pages[7].nameText(), "one");
  EXPECT_EQ(pages[8].nameText(), "other");
  EXPECT_FALSE(pages[9].canPlay());
}

TEST(OwnPages, APageNumberInTwoTextsIsRefusedAndBothAreNamed) {
  EXPECT_EQ(refusalOf({{"one.txt", kOne}, {"other.txt", kOther}, {"third.txt", kOne}}),
            "page 7 is in one.txt and in third.txt: give one of them another number");
}

TEST(OwnPages, ABrokenTextIsNamed) {
  EXPECT_THAT(refusalOf({{"one.txt", kOne}, {"bad.txt", "darwinop motion 1\n[page 3]\nNeck = x\n"}}),
              HasSubstr("bad.txt, line 3, page 3: Neck"));
}

}  // namespace
}  // namespace darwinop::motion
