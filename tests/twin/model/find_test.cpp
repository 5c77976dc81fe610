// Search path of model files.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/shipped.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

/// A temporary folder with models; the destructor restores the environment.
class OwnModels : public testing::Test {
 protected:
  OwnModels() : was_{fs::current_path()} {}
  ~OwnModels() override {
    unsetenv("DARWINOP_MODELS");
    fs::current_path(was_);
  }
  std::string put(const std::string& name, const std::string& text = kNamed) {
    std::ofstream{folder_ / name} << text;
    return folder_ / name;
  }
  void use() { setenv("DARWINOP_MODELS", (folder_ / "").c_str(), 1); }

  TemporaryFolder folder_;

 private:
  fs::path was_;
};

TEST(FindModel, ShippedOnesAreFoundByName) {
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), DARWINOP_SHIPPED_MODELS "/darwin-op.ini"));
  EXPECT_THAT(shippedModels(), Contains("darwin-op"));
  EXPECT_THAT(shippedModels(), Contains("webots-2013"));
}

TEST(FindModel, AnUnknownNameIsRefusedWithTheShippedOnes) {
  EXPECT_THAT(refusal([] { findModel("darvin-op"); }), AllOf(HasSubstr("\"darvin-op\""), HasSubstr("darwin-op"),
                                                             HasSubstr("webots-2013"), HasSubstr("./my-robot.ini")));
  EXPECT_EQ(refusal([] { findModel("/nowhere/my.ini"); }),
            messages::kNoModelFile + std::string{"/nowhere/my.ini; "} + listShippedModels());
  EXPECT_THAT(refusal([] { findModel(""); }), StartsWith(messages::kNoModel + std::string{"\"\""}));
}

TEST_F(OwnModels, AFolderOfTheUserComesBeforeTheShippedOnes) {
  const std::string mine = put("mine.ini"), other = put("darwin-op.ini");
  use();
  EXPECT_TRUE(fs::equivalent(findModel("mine"), mine));
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), other));
  EXPECT_THAT(shippedModels(), testing::ElementsAre("darwin-op", "mine", "webots-2013"));
}

TEST_F(OwnModels, ANameWithASlashOrIniIsAPath) {
  const std::string mine = put("mine.ini"), bare = put("bare");
  EXPECT_EQ(findModel(mine), mine);
  fs::current_path(folder_ / "");
  EXPECT_EQ(findModel("mine.ini"), "mine.ini");
  EXPECT_EQ(findModel("bare"), "bare");
  fs::create_directory("darwin-op");  // a folder of that name is not a model file
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), DARWINOP_SHIPPED_MODELS "/darwin-op.ini"));
}

TEST_F(OwnModels, AModelIsReadWithTheBodyInItsFolder) {
  const std::string mine = put("mine.ini", kNamed + "[body]\nxml = own.xml\n");
  put("own.xml", "<mujoco/>");
  EXPECT_TRUE(fs::equivalent(readModel(mine).folder, folder_ / ""));
}

TEST_F(OwnModels, ACopyOfAShippedModelUsesTheShippedBody) {
  EXPECT_TRUE(fs::equivalent(readModel(put("mine.ini")).folder, DARWINOP_SHIPPED_MODELS));
}

TEST_F(OwnModels, AMissingBodyIsRefusedWithTheLineThatNamesIt) {
  const std::string mine = put("mine.ini", kNamed + "[body]\nxml = own.xml\n");
  EXPECT_THAT(
      refusal([&] { readModel(mine); }),
      AllOf(StartsWith(mine + ", line 4: [body] xml = own.xml: " + messages::kNoBodyFile + (folder_ / "own.xml")),
            HasSubstr("darwin-op.xml")));
  fs::create_directory(folder_ / "own.xml");
  EXPECT_THAT(refusal([&] { readModel(mine); }), HasSubstr((folder_ / "own.xml") + messages::kIsFolder));
}

TEST_F(OwnModels, AFolderOrAMissingFileIsRefused) {
  EXPECT_THAT(refusal([&] { readModel(folder_ / ""); }),
              AllOf(StartsWith((folder_ / "") + messages::kIsFolder), HasSubstr("darwin-op.ini")));
  EXPECT_EQ(refusal([&] { readModel(folder_ / "no.ini"); }),
            messages::kNoModelFile + (folder_ / "no.ini") + "; " + listShippedModels());
}

}  // namespace
}  // namespace darwinop::twin
