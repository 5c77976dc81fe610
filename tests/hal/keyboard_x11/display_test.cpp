// The text of DISPLAY, and servers that are not there.
#include "hal/keyboard_x11/display.hpp"

#include <gmock/gmock.h>

namespace darwinop::x11 {
namespace {

using testing::HasSubstr;

std::string whyNot(const std::string& display) {
  try {
    static_cast<void>(connectTo(parseDisplay(display)));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Display, HasAHostANumberAndAScreen) {
  EXPECT_EQ(parseDisplay(":0"), (DisplayName{"", 0, 0}));
  EXPECT_EQ(parseDisplay(":12.1"), (DisplayName{"", 12, 1}));
  EXPECT_EQ(parseDisplay("localhost:10.0"), (DisplayName{"localhost", 10, 0}));
}

TEST(Display, ThatIsNoneIsNamed) {
  EXPECT_THAT(whyNot(""), HasSubstr("not set"));
  for (const char* const text : {"0", "here", ":", ":x", ":0.", ":0.1.2", ":-1", ":99999"})
    EXPECT_THAT(whyNot(text), HasSubstr(text));
}

TEST(Display, WithoutAServerSaysSo) {
  EXPECT_THAT(whyNot(":9876"), HasSubstr("no X server answers at DISPLAY=:9876"));
  EXPECT_THAT(whyNot("localhost:9876"), HasSubstr("Connection refused"));
}

TEST(Display, OfAHostByNameIsNotLookedUp) {
  EXPECT_THAT(whyNot("pc.example:0"), HasSubstr("write the number of pc.example"));
}

}  // namespace
}  // namespace darwinop::x11
