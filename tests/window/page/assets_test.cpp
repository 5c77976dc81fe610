// Embedded files of the page are complete.
#include "window/page/assets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "window/secret.hpp"

namespace darwinop {
namespace {

TEST(Assets, ContainAllFilesThatThePageRequests) {
  const auto all = window::assets();
  const std::string page{all[0].body};
  const std::regex wanted{"(?:src|href)=\"([^\"]+)\""};
  int found = 0;
  for (std::sregex_iterator it{page.begin(), page.end(), wanted}, end; it != end; ++it, ++found)
    EXPECT_TRUE(std::ranges::any_of(all, [&](const auto& asset) { return asset.name == (*it)[1].str(); })) << (*it)[1];
  EXPECT_EQ(found, 3);
  for (const window::Asset& asset : all) EXPECT_GT(asset.body.size(), 100U) << asset.name;
}

/// MIT and similar licences require their text in every copy.
TEST(Assets, TheScriptContainsTheLicenceOfEveryBundledPackage) {
  std::string script;
  for (const window::Asset& asset : window::assets())
    if (asset.name.ends_with("window.js")) script = asset.body;
  for (const char* owner : {"Leon Sorokin", "three.js authors"})
    EXPECT_NE(script.find(owner), std::string::npos) << owner;
}

TEST(Secret, IsLongAndDifferentEachTime) {
  const std::string first = window::newSecret();
  EXPECT_EQ(first.size(), 32U);
  EXPECT_NE(first, window::newSecret());
}

}  // namespace
}  // namespace darwinop
