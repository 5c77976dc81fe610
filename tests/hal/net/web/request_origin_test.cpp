// Host and Origin check of the web server.
#include "hal/net/web/request_origin.hpp"

#include <gtest/gtest.h>

namespace darwinop::web {
namespace {

bool isAccepted(const OriginRules& rules, std::string_view host, std::optional<std::string_view> origin = {}) {
  return refusal(rules, {host, origin}).empty();
}

TEST(WebRequestOrigin, AcceptsAddressesAndKnownNamesOnly) {
  for (const char* host : {"localhost", "LocalHost:5024", "127.0.0.1", "127.0.0.1:5024", "192.168.123.1:80"})
    EXPECT_TRUE(isAccepted({}, host)) << host;
  for (const char* host : {"", "evil.example", "evil.example:5024", "localhost.evil.example", "127.0.0.1.evil.example",
                           "localhost:x", "1.2.3", "localhost:1:2", ":5024"})
    EXPECT_FALSE(isAccepted({}, host)) << host;
  using std::string_view_literals::operator""sv;
  EXPECT_FALSE(isAccepted({}, "127.0.0.1\0.evil.example"sv));
  EXPECT_TRUE(isAccepted({.hosts = {"darwin.local"}}, "Darwin.Local:5024"));
}

TEST(WebRequestOrigin, AcceptsProgramsAndAllowedOriginsOnly) {
  EXPECT_TRUE(isAccepted({}, "localhost:5024"));
  EXPECT_FALSE(isAccepted({}, "localhost:5024", "http://localhost:5024")) << "another server may run at that name";
  EXPECT_FALSE(isAccepted({}, "localhost:5024", "null"));
  EXPECT_FALSE(isAccepted({}, "localhost:5024", ""));
  const OriginRules rules{.origins = {"http://127.0.0.1:8080"}};
  EXPECT_TRUE(isAccepted(rules, "localhost:5024", "http://127.0.0.1:8080"));
  EXPECT_FALSE(isAccepted(rules, "localhost:5024", "http://127.0.0.1:80801"));
  EXPECT_FALSE(isAccepted(rules, "localhost:5024", "https://127.0.0.1:8080"));
  EXPECT_FALSE(isAccepted(rules, "evil.example", "http://127.0.0.1:8080"));
}

TEST(WebRequestOrigin, AcceptsItsOwnOriginIfConfigured) {
  const OriginRules rules{.own_origin = true};
  EXPECT_TRUE(isAccepted(rules, "localhost:5025", "http://localhost:5025"));
  EXPECT_FALSE(isAccepted(rules, "localhost:5025", "http://localhost:8080"));
  EXPECT_FALSE(isAccepted(rules, "localhost:5025", "null"));
  EXPECT_FALSE(isAccepted(rules, "evil.example:5025", "http://evil.example:5025")) << "DNS rebinding";
}

TEST(WebRequestOrigin, ARefusalEndsWithWhatThisServerOffers) {
  const OriginRules rules{.own_origin = true, .host_remedy = "open it at home", .origin_remedy = "open it here"};
  EXPECT_TRUE(refusal(rules, {.host = "mypc:9000", .origin = {}}).ends_with("; open it at home"));
  EXPECT_TRUE(refusal(rules, {.host = "localhost", .origin = "null"}).ends_with("; open it here"));
}

}  // namespace
}  // namespace darwinop::web
