// Text of somebody else, shown on a terminal.
#include "core/text/printable.hpp"

#include <gtest/gtest.h>

namespace darwinop {
namespace {

TEST(Printable, OrdinaryTextStaysAsItIs) {
  for (const char* const text : {"", "the MODE button was held", "C:\\x", "Größe 20 °C — 正", "\xF0\x9F\xA4\x96"})
    EXPECT_EQ(text::printable(text), text);
}

TEST(Printable, CommandsForATerminalAreShownAndNotCarriedOut) {
  EXPECT_EQ(text::printable("\x1b[2J\x1b]0;title\x07"), "\\x1b[2J\\x1b]0;title\\x07");
  EXPECT_EQ(text::printable("good\rbad\nnew line\t\b\x7f"), "good\\x0dbad\\x0anew line\\x09\\x08\\x7f");
  EXPECT_EQ(text::printable("\xC2\x9B"
                            "2J"),
            "\\xc2\\x9b2J")
      << "CSI of eight bits";
  EXPECT_EQ(text::printable("\xE2\x80\xAE"
                            "gpj"),
            "\\xe2\\x80\\xaegpj")
      << "written from right to left";
  EXPECT_EQ(text::printable(std::string_view{"a\0b", 3}), "a\\x00b");
}

TEST(Printable, WhatIsNotUtf8IsShownAsBytes) {
  EXPECT_EQ(text::printable("\x9b"
                            "2J"),
            "\\x9b2J");
  EXPECT_EQ(text::printable("\xE2\x82"), "\\xe2\\x82") << "cut off";
  EXPECT_EQ(text::printable("\xC0\x9B"), "\\xc0\\x9b") << "an escape in a longer form than it needs";
}

TEST(Printable, LinesStayLines) {
  EXPECT_EQ(text::printableLines("two\n\x1b[1mlines\n"), "two\n\\x1b[1mlines\n");
  EXPECT_EQ(text::printableLines(""), "");
}

TEST(Printable, NoTextOfTwoBytesReachesATerminalAsACommand) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second)
      for (const char shown : text::printable(std::string{static_cast<char>(first), static_cast<char>(second)}))
        ASSERT_TRUE(static_cast<unsigned char>(shown) >= 0x20 && shown != 0x7F) << first << " " << second;
}

}  // namespace
}  // namespace darwinop
