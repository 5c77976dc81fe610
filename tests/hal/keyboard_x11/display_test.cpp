// DISPLAY names, and missing servers.
#include "hal/keyboard_x11/display.hpp"

#include <gmock/gmock.h>

namespace darwinop::x11 {
namespace {

using testing::HasSubstr;

std::string rejection(const std::string& display) {
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

TEST(Display, NamesAnInvalidDisplay) {
  EXPECT_THAT(rejection(""), HasSubstr("not set"));
  for (const char* const text : {"0", "here", ":", ":x", ":0.", ":0.1.2", ":-1", ":99999"})
    EXPECT_THAT(rejection(text), HasSubstr(text));
}

TEST(Display, ReportsAMissingServer) {
  EXPECT_THAT(rejection(":9876"), HasSubstr("cannot connect to the X server at DISPLAY=:9876"));
  EXPECT_THAT(rejection("localhost:9876"), HasSubstr("Connection refused"));
}

TEST(Display, DoesNotResolveHostNames) {
  EXPECT_THAT(rejection("pc.example:0"), HasSubstr("use the IP address of pc.example"));
}

}  // namespace
}  // namespace darwinop::x11
