// docs/twin/models.md says what the code reads.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "twin/model/keys.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

std::string page() {
  std::ifstream file{DARWINOP_MODELS_PAGE};
  EXPECT_TRUE(file) << DARWINOP_MODELS_PAGE;
  return {std::istreambuf_iterator<char>{file}, {}};
}

TEST(ModelDocs, ThePageHasTheTableOfAllKeys) {
  EXPECT_THAT(page(), testing::HasSubstr(keysAsMarkdown())) << "put this table there:\n" << keysAsMarkdown();
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
