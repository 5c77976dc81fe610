// DISPLAY names, and missing servers.
#include "hal/keyboard_x11/display.hpp"

#include <gmock/gmock.h>

#include <cerrno>
#include <cstring>

namespace darwinop::x11 {
namespace {

using testing::AllOf;
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
  EXPECT_EQ(rejection(""), kDisplayNotSet);
  for (const char* const text : {"0", "here", ":", ":x", ":0.", ":0.1.2", ":-1", ":99999"})
    EXPECT_THAT(rejection(text), HasSubstr(text));
}

TEST(Display, ReportsAMissingServer) {
  EXPECT_THAT(rejection(":9876"), AllOf(HasSubstr("DISPLAY=:9876 "), HasSubstr(std::strerror(ENOENT))));
  EXPECT_THAT(rejection("localhost:9876"), HasSubstr(std::strerror(ECONNREFUSED)));
}

TEST(Display, DoesNotResolveHostNames) {
  EXPECT_THAT(rejection("pc.example:0"), AllOf(HasSubstr("IP address"), HasSubstr("pc.example")));
}

}  // namespace
}  // namespace darwinop::x11
