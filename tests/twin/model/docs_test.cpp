// docs/twin/models.md agrees with the key table.
#include <gmock/gmock.h>

#include <iterator>

#include "support/text_of.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

std::string page() {
  return textOf(DARWINOP_MODELS_PAGE);
}

TEST(ModelDocs, ThePageHasTheTableOfAllKeys) {
  EXPECT_THAT(page(), testing::HasSubstr(keysAsMarkdown())) << "replace the table by:\n" << keysAsMarkdown();
}

TEST(ModelDocs, TheModelsOfThePageAreSound) {
  const std::string text = page();
  constexpr std::string_view kBegin = "```ini\n";
  int models = 0;
  for (std::size_t at = text.find(kBegin); at != text.npos; at = text.find(kBegin, at + 1), ++models) {
    std::string ini = text.substr(at + kBegin.size(), text.find("```", at + kBegin.size()) - at - kBegin.size());
    if (ini.find("[model]") == ini.npos) ini = kNamed + ini;
    EXPECT_EQ(refusal([&] { parseModel(ini, "models.md"); }), "");
  }
  EXPECT_GE(models, 2);
}

}  // namespace
}  // namespace darwinop::twin
