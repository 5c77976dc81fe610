// JSON text of strings with invalid UTF-8, and its layout.
#include "core/json/json_text.hpp"

#include <gtest/gtest.h>

namespace darwinop {
namespace {

TEST(JsonText, AnInvalidByteIsReplaced) {
  EXPECT_EQ(jsonText(nlohmann::json("a\xFF")), "\"a\uFFFD\"");
}

TEST(JsonText, IsOneLineUnlessIndented) {
  const nlohmann::ordered_json value{{"b", 1}, {"a", 2}};
  EXPECT_EQ(jsonText(value), R"({"b":1,"a":2})");
  EXPECT_EQ(jsonText(value, 1), "{\n \"b\": 1,\n \"a\": 2\n}");
}

TEST(JsonText, AsciiEscapesOtherCharacters) {
  EXPECT_EQ(jsonText(nlohmann::json("°"), -1, true), R"("\u00b0")");
}

}  // namespace
}  // namespace darwinop
