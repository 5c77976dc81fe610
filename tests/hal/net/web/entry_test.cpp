// Who may come in, by Host and Origin.
#include "hal/net/web/entry.hpp"

#include <gtest/gtest.h>

namespace darwinop::web {
namespace {

bool mayCome(const EntryRules& rules, std::string_view host, std::optional<std::string_view> origin = {}) {
  return refusal(rules, {host, origin}).empty();
}

TEST(WebEntry, TakesNumbersAndNamesItKnowsAndNoOthers) {
  for (const char* host : {"localhost", "LocalHost:5024", "127.0.0.1", "127.0.0.1:5024", "192.168.123.1:80"})
    EXPECT_TRUE(mayCome({}, host)) << host;
  for (const char* host : {"", "evil.example", "evil.example:5024", "localhost.evil.example", "127.0.0.1.evil.example",
                           "localhost:x", "1.2.3", "localhost:1:2", ":5024"})
    EXPECT_FALSE(mayCome({}, host)) << host;
  using std::string_view_literals::operator""sv;
  EXPECT_FALSE(mayCome({}, "127.0.0.1\0.evil.example"sv));
  EXPECT_TRUE(mayCome({.hosts = {"darwin.local"}}, "Darwin.Local:5024"));
}

TEST(WebEntry, TakesProgramsAndOnlyThosePagesThatAreNamed) {
  EXPECT_TRUE(mayCome({}, "localhost:5024"));
  EXPECT_FALSE(mayCome({}, "localhost:5024", "http://localhost:5024")) << "another server may run at that name";
  EXPECT_FALSE(mayCome({}, "localhost:5024", "null"));
  EXPECT_FALSE(mayCome({}, "localhost:5024", ""));
  const EntryRules rules{.origins = {"http://127.0.0.1:8080"}};
  EXPECT_TRUE(mayCome(rules, "localhost:5024", "http://127.0.0.1:8080"));
  EXPECT_FALSE(mayCome(rules, "localhost:5024", "http://127.0.0.1:80801"));
  EXPECT_FALSE(mayCome(rules, "localhost:5024", "https://127.0.0.1:8080"));
  EXPECT_FALSE(mayCome(rules, "evil.example", "http://127.0.0.1:8080"));
}

TEST(WebEntry, TakesItsOwnPagesWhereItHasSome) {
  const EntryRules rules{.own_origin = true};
  EXPECT_TRUE(mayCome(rules, "localhost:5025", "http://localhost:5025"));
  EXPECT_FALSE(mayCome(rules, "localhost:5025", "http://localhost:8080"));
  EXPECT_FALSE(mayCome(rules, "localhost:5025", "null"));
  EXPECT_FALSE(mayCome(rules, "evil.example:5025", "http://evil.example:5025")) << "DNS rebinding";
}

}  // namespace
}  // namespace darwinop::web
